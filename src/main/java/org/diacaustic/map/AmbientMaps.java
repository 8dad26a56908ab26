package org.diacaustic.map;

import java.util.Arrays;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.diacaustic.math.Rgb;
import org.diacaustic.parallel.Workers;

/**
 * Individual ambient maps [Heckbert 1990; Thesis 4.4]: every object that can show diffuse light has a map over its own
 * surface, and photons are sorted into its texels. Divided by the true areas of the texels this is an estimate of the mean
 * irradiance of each, without bias; blurring and smooth reading move light by about a texel and create none.
 *
 * <p>A lookup reads one texel or, smoothly, four: smooth reading has a bias of second order in the texel's size, where
 * single texels are off by first order and look like blocks; it is the default for that. Its cost does not depend on
 * how many photons there are.
 *
 * <p>Photons are added in the order of the store, so the bits do not depend on threads.
 */
public final class AmbientMaps implements IlluminationMap {
    /** What a texel takes with maps for both sides, areas and joining included: for those who plan sizes. */
    public static final int BYTES_PER_TEXEL = 2 * (3 * Double.BYTES + Integer.BYTES) + Double.BYTES + Integer.BYTES;

    private static final int BLOCK = 1 << 14;

    private final AmbientMap[] maps;
    private final boolean interpolates;
    private final long bytes;

    private AmbientMaps(AmbientMap[] maps, boolean interpolates, long bytes) {
        this.maps = maps;
        this.interpolates = interpolates;
        this.bytes = bytes;
    }

    /**
     * Sorts photons into maps. Photons on objects without a chart are left out: those show no diffuse light.
     *
     * @param charts of the objects that can show diffuse light, at most one for each
     * @throws IllegalArgumentException if two charts are of the same object
     */
    public static AmbientMaps of(
            PhotonStore store, List<AmbientChart> charts, AmbientOptions options, Workers workers) {
        AmbientChart[] byObject = byObject(charts);
        int[] texels = texels(store, byObject, workers);
        AmbientMap.Builder[] builders = new AmbientMap.Builder[2 * byObject.length];
        SurfacePoint point = new SurfacePoint();
        Rgb power = new Rgb();
        for (int i = 0; i < texels.length; i++) {
            if (texels[i] != TexelGrid.NONE) {
                store.position(i, point);
                store.power(i, power);
                builder(builders, byObject[point.object], point.front, options).add(texels[i], power);
            }
        }
        AmbientMap[] maps = new AmbientMap[builders.length];
        for (int i = 0; i < maps.length; i++) {
            boolean shared = (i & 1) != 0 && builders[i] == builders[i - 1];
            maps[i] = builders[i] == null
                    ? null
                    : shared ? maps[i - 1] : builders[i].build(divisor(builders[i], options), options.blur());
        }
        return new AmbientMaps(maps, options.interpolates(), bytes(charts, maps));
    }

    private static AmbientChart[] byObject(List<AmbientChart> charts) {
        AmbientChart[] byObject = new AmbientChart
                [charts.stream().mapToInt(AmbientChart::object).max().orElse(-1) + 1];
        for (AmbientChart chart : charts) {
            if (byObject[chart.object()] != null) {
                throw new IllegalArgumentException("object " + chart.object() + " has two charts");
            }
            byObject[chart.object()] = chart;
        }
        return byObject;
    }

    /** The texel of every photon on its object's map: most of the work, and no photon's depends on another's. */
    private static int[] texels(PhotonStore store, AmbientChart[] charts, Workers workers) {
        int[] texels = new int[store.size()];
        workers.run((texels.length + BLOCK - 1) / BLOCK, () -> {
            SurfacePoint point = new SurfacePoint();
            return block -> {
                int end = Math.min(texels.length, (block + 1) * BLOCK);
                for (int i = block * BLOCK; i < end; i++) {
                    store.position(i, point);
                    AmbientChart chart = point.object < charts.length ? charts[point.object] : null;
                    texels[i] = chart == null ? TexelGrid.NONE : chart.grid().texel(point.x, point.y, point.z);
                }
            };
        });
        return texels;
    }

    /** The map of a side: made when the first photon lands there, and for both sides if they are not told apart. */
    private static AmbientMap.Builder builder(
            AmbientMap.Builder[] builders, AmbientChart chart, boolean front, AmbientOptions options) {
        int back = 2 * chart.object();
        int side = front ? back + 1 : back;
        if (builders[side] == null) {
            JoinedTexels texels = options.calibration() == AmbientCalibration.DENSITY
                    ? chart.texels()
                    : JoinedTexels.alike(chart.grid());
            builders[side] = new AmbientMap.Builder(chart.grid(), texels);
            if (!options.separatesSides()) {
                builders[back] = builders[side];
                builders[back + 1] = builders[side];
            }
        }
        return builders[side];
    }

    /** What powers are divided by, besides the areas. */
    private static double divisor(AmbientMap.Builder builder, AmbientOptions options) {
        if (options.calibration() == AmbientCalibration.DENSITY) {
            return 1;
        }
        return Double.isNaN(options.expectedCount())
                ? (double) builder.photonCount() / builder.litTexels()
                : options.expectedCount();
    }

    private static long bytes(List<AmbientChart> charts, AmbientMap[] maps) {
        Set<JoinedTexels> texels = Collections.newSetFromMap(new IdentityHashMap<>());
        charts.forEach(chart -> texels.add(chart.texels()));
        long sum = 0;
        for (int i = 0; i < maps.length; i++) {
            if (maps[i] != null && (i % 2 == 0 || maps[i] != maps[i - 1])) {
                sum += maps[i].bytes();
                texels.add(maps[i].texels());
            }
        }
        return sum + texels.stream().mapToLong(JoinedTexels::bytes).sum();
    }

    @Override
    public Lookup lookup() {
        return new Reader();
    }

    @Override
    public long bytes() {
        return bytes;
    }

    /** The maps that hold any light. */
    List<AmbientMap> lit() {
        return Arrays.stream(maps).filter(Objects::nonNull).distinct().toList();
    }

    private final class Reader implements Lookup {
        private long texelsRead;
        private long photonsUsed;

        @Override
        public void irradiance(SurfacePoint at, Rgb irradiance) {
            int side = 2 * at.object + (at.front ? 1 : 0);
            AmbientMap map = side < maps.length ? maps[side] : null;
            if (map == null) {
                irradiance.set(0, 0, 0);
            } else if (interpolates) {
                texelsRead += 4;
                photonsUsed += map.interpolated(at, irradiance);
            } else {
                texelsRead++;
                photonsUsed += map.nearest(at, irradiance);
            }
        }

        @Override
        public long nodesExamined() {
            return texelsRead;
        }

        @Override
        public long photonsUsed() {
            return photonsUsed;
        }
    }
}
