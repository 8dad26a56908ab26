package org.diacaustic.map;

import java.util.Arrays;
import java.util.Collections;
import java.util.Random;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.SampleStream;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;

/**
 * What benchmarks gather: light from straight above, refracted by waves, on a floor and a sphere under them. Photons crowd on
 * caustics and lie on surfaces; a tree that is fast for a cube full of points need not be fast for them.
 */
final class CausticPhotons {
    /** Of water. */
    private static final double INDEX_OF_REFRACTION = 1.33;

    private static final double FLOOR = -1;

    /** The sphere stands on the floor. */
    private static final double SPHERE = 0.35;

    /** Of each wave: twice π ÷ its length along x and z, its height, its phase. */
    private static final double[][] WAVES = {{9, 2, 0.012, 0}, {-5, 17, 0.006, 1}, {13, -11, 0.005, 2}, {3, 7, 0.012, 4}
    };

    private final SampleStream random = new SampleStream();
    private final SurfacePoint landing = new SurfacePoint();
    private final Rgb power = new Rgb().set(1, 0.9, 0.8);

    /** The photons that land first when light falls on the waves at random. */
    static PhotonStore store(int count) {
        PhotonStore store = new PhotonStore(new Vector3(0, FLOOR, 0), 1, count);
        PhotonSlice slice = store.slice();
        new CausticPhotons().add(0, count, slice);
        store.append(slice);
        return store;
    }

    /** Adds the photons of a task. */
    void add(int task, int count, PhotonSlice slice) {
        random.start(1999, task, 0);
        while (slice.size() < count) {
            if (land(landing, 2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1)) {
                slice.add(landing, power);
            }
        }
    }

    /** The radius within which there is a number of photons, on average over what is asked. */
    static double radiusFor(int count, int photons) {
        PhotonTree tree = PhotonTree.movedFrom(store(photons), new Workers(1));
        SurfacePoint[] points = queries(2000, false);
        double low = 0;
        double high = 1;
        for (int step = 0; step < 30; step++) {
            double radius = (low + high) / 2;
            PhotonSearch search = new PhotonSearch(tree, PhotonFilter.TWO_SIDED_NORMAL);
            long found = 0;
            for (SurfacePoint point : points) {
                search.start(point, radius);
                for (int next = search.next(); next >= 0; next = search.next()) {
                    found += next;
                }
            }
            if (found > (long) count * points.length) {
                high = radius;
            } else {
                low = radius;
            }
        }
        return low;
    }

    /** Follows light from above the waves to where it lands. */
    boolean land(SurfacePoint out, double x, double z) {
        double height = 0;
        double slopeX = 0;
        double slopeZ = 0;
        for (double[] wave : WAVES) {
            double phase = wave[0] * x + wave[1] * z + wave[3];
            height += wave[2] * Math.sin(phase);
            slopeX += wave[2] * wave[0] * Math.cos(phase);
            slopeZ += wave[2] * wave[1] * Math.cos(phase);
        }
        // Snell's law for a ray straight down; the normal is (−slopeX, 1, −slopeZ) ÷ length.
        double cosine = 1 / Math.sqrt(1 + slopeX * slopeX + slopeZ * slopeZ);
        double eta = 1 / INDEX_OF_REFRACTION;
        double along = eta * cosine - Math.sqrt(1 - eta * eta * (1 - cosine * cosine));
        double dx = -along * slopeX * cosine;
        double dy = -eta + along * cosine;
        double dz = -along * slopeZ * cosine;
        return land(out, x, height, z, dx, dy, dz);
    }

    /** Sets the first point of sphere or floor on a ray of direction of length 1; false if it is beyond the floor. */
    static boolean land(SurfacePoint out, double x, double y, double z, double dx, double dy, double dz) {
        double toCentreY = FLOOR + SPHERE - y;
        double middle = -x * dx + toCentreY * dy - z * dz;
        double missedSquared = x * x + toCentreY * toCentreY + z * z - middle * middle;
        boolean onSphere = missedSquared < SPHERE * SPHERE;
        double distance = onSphere ? middle - Math.sqrt(SPHERE * SPHERE - missedSquared) : (FLOOR - y) / dy;
        out.x = x + distance * dx;
        out.y = onSphere ? y + distance * dy : FLOOR;
        out.z = z + distance * dz;
        out.normalX = onSphere ? out.x / SPHERE : 0;
        out.normalY = onSphere ? (out.y - FLOOR - SPHERE) / SPHERE : 1;
        out.normalZ = onSphere ? out.z / SPHERE : 0;
        out.object = onSphere ? 1 : 0;
        out.front = true;
        return distance > 0 && Math.abs(out.x) <= 1 && Math.abs(out.z) <= 1;
    }

    /**
     * Points where an eye above the waterline would ask, row by row; in random order if so wanted.
     *
     * @param count about as many
     */
    static SurfacePoint[] queries(int count, boolean shuffled) {
        int side = (int) Math.round(Math.sqrt(4.72 * count));
        SurfacePoint[] all = new SurfacePoint[side * side];
        int found = 0;
        for (int row = 0; row < side; row++) {
            for (int column = 0; column < side; column++) {
                double dx = (column + 0.5) / side * 2 - 1;
                double dy = (row + 0.5) / side * 2 - 1;
                // From (0, 1.2, 2.2) towards (0, −1, 0).
                double x = 0.62 * dx;
                double y = -0.7071 - 0.44 * dy;
                double z = -0.7071 + 0.44 * dy;
                double length = Math.sqrt(x * x + y * y + z * z);
                SurfacePoint point = new SurfacePoint();
                if (land(point, 0, 1.2, 2.2, x / length, y / length, z / length)) {
                    all[found++] = point;
                }
            }
        }
        SurfacePoint[] points = Arrays.copyOf(all, found);
        if (shuffled) {
            Collections.shuffle(Arrays.asList(points), new Random(7));
        }
        return points;
    }
}
