package org.diacaustic.trial;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.diacaustic.map.AmbientChart;
import org.diacaustic.map.AmbientMaps;
import org.diacaustic.map.AmbientOptions;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.map.PhotonSlice;
import org.diacaustic.map.PhotonStore;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.map.TexelGrid;
import org.diacaustic.math.CompensatedSum;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.SampleStream;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.preprocess.AmbientCharts;
import org.diacaustic.preprocess.ChartSizing;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.shape.Sphere;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Ambient maps over spheres. */
final class AmbientMapTrials {
    private static final Pattern BOX = Pattern.compile("(\\d+)\\s*x\\s*(\\d+).*");
    private static final int PHOTONS = 20_000;
    private static final int SEED = 7;

    private AmbientMapTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "sphere_texel_area",
                "The areas that a render measures for the ambient map of a sphere: of a texel at the south pole, of one next to the"
                        + " equator, and of all.",
                AmbientMapTrials::areas);
        operations.add(
                "map_blur",
                "20,000 photons of unequal power, with a fixed seed, over a map of 64 x 32 texels on a sphere, read texel by texel"
                        + " with and without the blur; then photons in one texel at the seam, and in one at a pole, whose light must"
                        + " reach the texels across.",
                AmbientMapTrials::blur);
    }

    private static void areas(NumericCase asked, Checks checks) {
        int width = (int) asked.inputs().integer("width");
        int height = (int) asked.inputs().integer("height");
        if (width % 2 != 0) {
            checks.notApplicable("maps around a sphere have an even number of columns, so that each texel has one"
                    + " straight over the pole");
            return;
        }
        AmbientChart chart = chart(width, height, asked.inputs().number("R", 1));
        double pole = chart.area(0);
        double equator = chart.area(height / 2 * width);
        CompensatedSum sum = new CompensatedSum();
        for (int texel = 0; texel < width * height; texel++) {
            sum.add(chart.area(texel));
        }
        checks.number("pole_texel", pole);
        checks.number("equator_texel", equator);
        checks.number("ratio_equator_to_pole", equator / pole);
        checks.number("sum_all", sum.value());
    }

    private static AmbientChart chart(int width, int height, double radius) {
        SceneObject ball = new SceneObject("ball", new Sphere(Vector3.ZERO, radius), Stage.WHITE);
        return AmbientCharts.of(SceneIndex.of(List.of(ball), false), ChartSizing.equal(width, height), new Workers(1))
                .get(0);
    }

    private static void blur(NumericCase asked, Checks checks) {
        int side = side(asked.inputs().text("blur"));
        AmbientChart chart = chart(64, 32, 1);
        PhotonStore photons = scattered(chart.grid());
        double before = flux(chart, lookup(chart, photons, 0));
        double after = flux(chart, lookup(chart, photons, side));
        checks.number("sum_flux_after_over_before", after / before);
        if (asked.expected().has("seam") && side > 1) {
            int columns = chart.grid().columns();
            int row = chart.grid().rows() / 2 * columns;
            checks.holds(
                    "light of column 0 reaches the last column",
                    irradiance(chart, lookup(chart, photonsIn(chart.grid(), row), side), row + columns - 1) > 0);
            checks.holds(
                    "light of row 0 goes over the pole",
                    irradiance(chart, lookup(chart, photonsIn(chart.grid(), 0), side), columns / 2) > 0);
        }
    }

    private static int side(String text) {
        Matcher box = BOX.matcher(text);
        if (!box.matches() || !box.group(1).equals(box.group(2))) {
            throw new CaseFault("inputs.blur should be a square box such as 3x3, but is " + text);
        }
        int side = Integer.parseInt(box.group(1));
        if (side % 2 == 0) {
            throw new CaseFault("a blur has an odd side here, but inputs.blur is " + text);
        }
        return side;
    }

    private static PhotonStore scattered(TexelGrid grid) {
        SampleStream random = new SampleStream();
        random.start(SEED, 0, 0);
        PhotonStore store = new PhotonStore(Vector3.ZERO, 1, PHOTONS);
        PhotonSlice slice = store.slice();
        for (int i = 0; i < PHOTONS; i++) {
            add(slice, grid, random.nextDouble(), random.nextDouble(), random.nextDouble());
        }
        store.append(slice);
        return store;
    }

    private static PhotonStore photonsIn(TexelGrid grid, int texel) {
        PhotonStore store = new PhotonStore(Vector3.ZERO, 1, 1);
        PhotonSlice slice = store.slice();
        add(slice, grid, u(grid, texel), v(grid, texel), 1);
        store.append(slice);
        return store;
    }

    private static void add(PhotonSlice slice, TexelGrid grid, double u, double v, double power) {
        slice.add(pointAt(grid, u, v), new Rgb().set(power, power, power));
    }

    /** A point of the unit sphere, which shows its front. */
    private static SurfacePoint pointAt(TexelGrid grid, double u, double v) {
        Ray ray = new Ray();
        grid.chart().aim(u, v, ray);
        SurfacePoint point = new SurfacePoint();
        point.x = ray.directionX;
        point.y = ray.directionY;
        point.z = ray.directionZ;
        point.normalX = point.x;
        point.normalY = point.y;
        point.normalZ = point.z;
        point.front = true;
        return point;
    }

    private static double u(TexelGrid grid, int texel) {
        return (texel % grid.columns() + 0.5) / grid.columns();
    }

    private static double v(TexelGrid grid, int texel) {
        int row = texel / grid.columns();
        return (row + 0.5) / grid.rows();
    }

    private static IlluminationMap.Lookup lookup(AmbientChart chart, PhotonStore photons, int blur) {
        AmbientOptions options = AmbientOptions.physical().withBlur(blur).interpolating(false);
        return AmbientMaps.of(photons, List.of(chart), options, new Workers(1)).lookup();
    }

    private static double irradiance(AmbientChart chart, IlluminationMap.Lookup lookup, int texel) {
        Rgb irradiance = new Rgb();
        lookup.irradiance(pointAt(chart.grid(), u(chart.grid(), texel), v(chart.grid(), texel)), irradiance);
        return irradiance.green;
    }

    private static double flux(AmbientChart chart, IlluminationMap.Lookup lookup) {
        CompensatedSum sum = new CompensatedSum();
        for (int texel = 0; texel < chart.grid().size(); texel++) {
            sum.add(irradiance(chart, lookup, texel) * chart.area(texel));
        }
        return sum.value();
    }
}
