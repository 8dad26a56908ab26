package org.diacaustic.trial;

import java.util.SplittableRandom;
import java.util.function.DoubleSupplier;
import java.util.stream.DoubleStream;
import org.diacaustic.map.Estimator;
import org.diacaustic.map.Kernel;
import org.diacaustic.map.PhotonFilter;
import org.diacaustic.map.PhotonTree;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Vector3;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;
import org.diacaustic.stability.Values;

/** What photon maps make of photons that are evenly spread over surfaces: where a map is wrong, and by how much. */
final class DensityTrials {
    private static final int PHOTONS = 200_000;
    private static final double SIGMAS = 4;

    /** Powers are kept in single precision: all photons of a power are off alike. */
    private static final double SINGLE = 0x1p-24;

    private DensityTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "knn_bias",
                "PhotonMap lookups of the k nearest, each in a map of its own with Poisson photons about the point (seed 1,"
                        + " up to 20000 maps). The renderer divides k - 1 powers by the area; k over the area is that times"
                        + " k/(k - 1). 4 sigma of the true deviation 1/sqrt(k - 2); for k = 2, which has none, of the sample,"
                        + " and the inverse, whose deviation is sqrt(k), is asked to be k on average.",
                DensityTrials::nearest);
        operations.add(
                "boundary_bias",
                "A PhotonMap lookup within radius 1 of 200000 random photons (seed 1) on a floor with a straight edge, and at"
                        + " the corner of a square. Of the acceptable answers the renderer gives the biased one: areas are not"
                        + " clipped. 4 sigma of the binomial count.",
                DensityTrials::edge);
        operations.add(
                "corner_leak",
                "PhotonMap lookups within radius 1 of 200000 random photons (seed 1) on a floor and a wall, with and without"
                        + " the two-sided normal filter; 4 sigma of the binomial count.",
                DensityTrials::corner);
        operations.add(
                "sphere_cap",
                "A PhotonMap lookup of 200000 random photons (seed 1) on the sphere, without and with the two-sided normal"
                        + " filter, which takes nothing up to r = 1.11 R. The cap area is what the lookup divides the power of"
                        + " a single photon by. 4 sigma of the binomial count.",
                DensityTrials::sphere);
    }

    private static void nearest(NumericCase asked, Checks checks) {
        int k = (int) asked.inputs().integer("k");
        if (k < 2 || k > 10_000) {
            throw new CaseFault("a lookup takes from 2 to 10000 photons here, not " + k);
        }
        double photons = 4 * k + 40;
        int maps = (int) Math.max(200, Math.min(20_000, 2_000_000 / photons));
        SplittableRandom random = new SplittableRandom(1);
        double[] ratios = new double[maps];
        double[] inverses = new double[maps];
        for (int i = 0; i < maps; i++) {
            ratios[i] = ratio(k, photons, random);
            inverses[i] = (k - 1) / ratios[i];
        }
        Sample ratio = Sample.of(ratios);
        double error = k > 2 ? 1 / Math.sqrt((k - 2.0) * maps) : ratio.error();
        double rim = k / (k - 1.0);
        statistic(checks, asked, "E_ratio_(k-1)_over_area", ratio.mean(), error);
        statistic(checks, asked, "E_ratio_k_over_area", rim * ratio.mean(), rim * error);
        checks.statistic("mean inverse", k, Sample.of(inverses).mean(), Math.sqrt((double) k / maps), SIGMAS);
        if (k > 4) {
            // The fourth moment of the inverse of a Gamma variable exists from there on.
            double kurtosis = 3 + 6 * (5.0 * k - 11) / ((k - 3.0) * (k - 4.0));
            double deviation = asked.expected().number("rel_sd_of_(k-1)_form");
            double ofDeviation = deviation * Math.sqrt((kurtosis - 1) / (4.0 * maps));
            statistic(checks, asked, "rel_sd_of_(k-1)_form", ratio.deviation(), ofDeviation);
        } else {
            checks.note("no sample tells the deviation for k < 5; the inverse stands for it");
        }
    }

    /** The estimate in the middle of photons of density 1 W·m⁻², as many as are expected in a disc of radius 1. */
    private static double ratio(int k, double expected, SplittableRandom random) {
        StoredPhotons photons = new StoredPhotons(Vector3.ZERO, 1, Integer.MAX_VALUE, Math.PI / expected);
        DoubleSupplier gap = () -> -StrictMath.log(1 - random.nextDouble()) / expected;
        DoubleStream.iterate(gap.getAsDouble(), square -> square <= 1, square -> square + gap.getAsDouble())
                .forEach(square -> {
                    double angle = random.nextDouble(2 * Math.PI);
                    double radius = Math.sqrt(square);
                    photons.add(StoredPhotons.floor(radius * StrictMath.cos(angle), radius * StrictMath.sin(angle)));
                });
        Estimator estimator = new Estimator.Nearest(k, Double.POSITIVE_INFINITY, Kernel.CONSTANT);
        return StoredPhotons.irradiance(
                photons.tree(), estimator, PhotonFilter.TWO_SIDED_NORMAL, StoredPhotons.floor(0, 0));
    }

    private static void edge(NumericCase asked, Checks checks) {
        double inside = finite(asked.inputs(), "d_over_r");
        SplittableRandom random = new SplittableRandom(1);
        double left = Math.max(0, inside - 1.5);
        edge(checks, asked, "E_ratio_unclipped", inside, left, Math.max(1, inside + 1.5), -1.5, random);
        if (asked.expected().has("corner_of_square_ratio_at_corner")) {
            edge(checks, asked, "corner_of_square_ratio_at_corner", 0, 0, 2, 0, random);
        }
        checks.note("the biased ratio: photons know no edges, as PhotonMap says");
    }

    /** Asks at (x, 0) of a floor from left to right and from front to 1.5. */
    private static void edge(
            Checks checks,
            NumericCase asked,
            String name,
            double x,
            double left,
            double right,
            double front,
            SplittableRandom random) {
        double area = (right - left) * (1.5 - front);
        StoredPhotons photons = new StoredPhotons(new Vector3(x, 0, 0), 2, PHOTONS, area / PHOTONS);
        for (int i = 0; i < PHOTONS; i++) {
            photons.add(StoredPhotons.floor(random.nextDouble(left, right), random.nextDouble(front, 1.5)));
        }
        double got = StoredPhotons.irradiance(
                photons.tree(), within(1), PhotonFilter.TWO_SIDED_NORMAL, StoredPhotons.floor(x, 0));
        binomial(checks, asked, name, got, area / Math.PI, PHOTONS);
    }

    private static void corner(NumericCase asked, Checks checks) {
        double fromWall = finite(asked.inputs(), "d_over_r");
        if (fromWall < 0) {
            throw new CaseFault("inputs.d_over_r: behind the wall is no floor to ask at");
        }
        SplittableRandom random = new SplittableRandom(1);
        double left = Math.max(0, fromWall - 1.5);
        double floor = 3 * (fromWall + 1.5 - left);
        double wall = 3 * 1.5;
        StoredPhotons photons = new StoredPhotons(new Vector3(fromWall, 0, 0), 2, PHOTONS, (floor + wall) / PHOTONS);
        for (int i = 0; i < PHOTONS; i++) {
            double z = random.nextDouble(-1.5, 1.5);
            double along = random.nextDouble(floor + wall) / 3;
            photons.add(
                    along < wall / 3
                            ? StoredPhotons.point(0, along, z, 1, 0, 0)
                            : StoredPhotons.floor(left + along - wall / 3, z));
        }
        PhotonTree tree = photons.tree();
        SurfacePoint at = StoredPhotons.floor(fromWall, 0);
        double areas = (floor + wall) / Math.PI;
        double filtered = StoredPhotons.irradiance(tree, within(1), PhotonFilter.TWO_SIDED_NORMAL, at);
        double unfiltered = StoredPhotons.irradiance(tree, within(1), PhotonFilter.NONE, at);
        binomial(checks, asked, "with_normal_filter", filtered, areas, PHOTONS);
        binomial(checks, asked, "without_normal_filter_ball", unfiltered, areas, PHOTONS);
    }

    private static void sphere(NumericCase asked, Checks checks) {
        double sphereRadius = finite(asked.inputs(), "R");
        double radius = finite(asked.inputs(), "r");
        checks.size(sphereRadius);
        SurfacePoint pole = onSphere(0, 0, 1, sphereRadius);
        PhotonTree one =
                new StoredPhotons(Vector3.ZERO, sphereRadius, 1, 1).add(pole).tree();
        if (asked.expected().has("cap_area")) {
            checks.number("cap_area", 1 / StoredPhotons.irradiance(one, within(radius), PhotonFilter.NONE, pole), "");
        }
        double area = 4 * Math.PI * sphereRadius * sphereRadius;
        SplittableRandom random = new SplittableRandom(1);
        StoredPhotons photons = new StoredPhotons(Vector3.ZERO, sphereRadius, PHOTONS, area / PHOTONS);
        for (int i = 0; i < PHOTONS; i++) {
            double z = random.nextDouble(-1, 1);
            double across = Math.sqrt(1 - z * z);
            double angle = random.nextDouble(2 * Math.PI);
            photons.add(onSphere(across * StrictMath.cos(angle), across * StrictMath.sin(angle), z, sphereRadius));
        }
        PhotonTree tree = photons.tree();
        double areas = 4 * (sphereRadius / radius) * (sphereRadius / radius);
        double unfiltered = StoredPhotons.irradiance(tree, within(radius), PhotonFilter.NONE, pole);
        binomial(checks, asked, "E_ratio", unfiltered, areas, PHOTONS);
        PhotonFilter filter = PhotonFilter.TWO_SIDED_NORMAL;
        double filtered = StoredPhotons.irradiance(tree, within(radius), filter, pole);
        double kept = Math.min(asked.expected().number("E_ratio"), 0.5 * (1 - filter.cosine()) * areas);
        binomial(checks, "with the normal filter", kept, filtered, areas, PHOTONS);
    }

    private static SurfacePoint onSphere(double x, double y, double z, double radius) {
        return StoredPhotons.point(x * radius, y * radius, z * radius, x, y, z);
    }

    private static Estimator within(double radius) {
        return new Estimator.Density(radius, Kernel.CONSTANT);
    }

    private static void statistic(Checks checks, NumericCase asked, String name, double got, double error) {
        checks.statistic(name, asked.expected().number(name), got, error, SIGMAS);
    }

    /** Compares a ratio that is the part of photons that were found, times the areas of the disc in which they all lie. */
    private static void binomial(Checks checks, NumericCase asked, String name, double got, double areas, int photons) {
        binomial(checks, name, asked.expected().number(name), got, areas, photons);
    }

    private static void binomial(Checks checks, String what, double expected, double got, double areas, int photons) {
        double part = expected / areas;
        double error = areas * Math.sqrt(Math.max(0, part * (1 - part)) / photons) + expected * SINGLE;
        checks.statistic(what, expected, got, error, SIGMAS);
    }

    private static double finite(Values inputs, String name) {
        double number = inputs.number(name);
        if (!Double.isFinite(number)) {
            throw new CaseFault("inputs." + name + " should be finite, but is " + number);
        }
        return number;
    }
}
