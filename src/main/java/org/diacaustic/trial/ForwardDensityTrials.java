package org.diacaustic.trial;

import java.util.Arrays;
import java.util.Locale;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegrator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegratorFactory;
import org.apache.commons.math3.stat.regression.SimpleRegression;
import org.diacaustic.light.DirectionalLight;
import org.diacaustic.light.Light;
import org.diacaustic.light.PointLight;
import org.diacaustic.map.Estimator;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.map.Kernel;
import org.diacaustic.map.PhotonFilter;
import org.diacaustic.map.PhotonTree;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.scene.Scene;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.Shape;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Whole forward passes against what the light is, or against what the lookup must make of it. */
final class ForwardDensityTrials {
    private static final int RAYS = 200_000;
    private static final double SIGMAS = 4;

    /** Points around the lamp's foot that see the same, at half its height; their discs do not overlap. */
    private static final int POINTS = 12;

    /** How many results there are for every repeat that a case asks for. */
    private static final int RESULTS_A_REPEAT = 4;

    /** Rays that all passes of a number of rays may take together, unless results are too few. */
    private static final double MOST_RAYS = 8e6;

    private static final double FROM_FOOT = 0.5;
    private static final double DISC = 0.1;

    private ForwardDensityTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "two_sided_leak",
                "A forward pass (200000 random rays, seed 1) of straight light through a sheet of index 1 onto a matt polygon,"
                        + " or, with a gap between its sides, a box of that thickness; lookups within radius 1 in the middle of"
                        + " both sides. 4 sigma of the binomial count; the dark side must be exactly 0.",
                ForwardDensityTrials::leak);
        operations.add(
                "disc_bias_floor",
                "A forward pass (200000 random rays aimed at a sheet of index 1, seed 1) and a lookup within r below the lamp,"
                        + " over the irradiance there; 4 sigma of the binomial count.",
                ForwardDensityTrials::disc);
        operations.add(
                "mean_of_maps",
                "Independent forward passes (seeds 1, 2, ...) of straight light through a sheet of index 1 onto a floor, and"
                        + " lookups of the k nearest, whose expectation is the irradiance exactly; its distance from the mean in"
                        + " true standard errors, sqrt((N - k + 1) / N / (k - 2) / maps).",
                ForwardDensityTrials::mean);
        operations.add(
                "mc_slope",
                "Forward passes (a seed each) of N random rays aimed at a sheet of index 1 below a lamp, and lookups within 0.1"
                        + " at 12 like points of the floor at half the lamp's height from its foot; together at least as many"
                        + " results as repeats, and as many passes until they took 8 million rays. Root mean square of what they"
                        + " are off from the mean irradiance of their disc (quadrature), over N by least squares. The slope"
                        + " of the lattices of 'planar' up to 100000 rays is noted.",
                ForwardDensityTrials::slope);
    }

    private static void leak(NumericCase asked, Checks checks) {
        double gap = asked.inputs().number("gap");
        if (!(gap >= 0 && gap < 1)) {
            throw new CaseFault("inputs.gap should be from 0 to below the radius, 1, but is " + gap);
        }
        Shape sheet = gap == 0 ? LitFloor.square(0, 2) : new Box(new Vector3(-2, -gap, -2), new Vector3(2, 0, 2));
        Scene scene = LitFloor.under(sheet, 1, 1.5, sun());
        PhotonTree tree = PhotonTree.movedFrom(
                LightRun.of(scene, LitFloor.within(1, 1), "random", RAYS).photons(), new Workers(1));
        SurfacePoint lit = StoredPhotons.floor(0, 0);
        SurfacePoint dark = StoredPhotons.point(0, -gap, 0, 0, -1, 0);
        PhotonFilter filter = PhotonFilter.TWO_SIDED_NORMAL;
        double through = asked.expected().number("dark_side_without_filter");
        checks.number(
                "dark_side_with_normal_filter",
                asked.expected().number("dark_side_with_normal_filter"),
                within(tree, filter, dark),
                asked.tolerance().number("dark_side_abs", 0));
        checks.statistic(
                "lit_side_ratio",
                asked.expected().number("lit_side_ratio"),
                within(tree, filter, lit),
                binomial(Math.PI / 9, RAYS),
                SIGMAS);
        checks.statistic(
                "dark_side_without_filter",
                through,
                within(tree, PhotonFilter.NONE, dark),
                through * binomial(through * Math.PI / 9, RAYS),
                SIGMAS);
    }

    private static double within(PhotonTree tree, PhotonFilter filter, SurfacePoint at) {
        return StoredPhotons.irradiance(tree, new Estimator.Density(1, Kernel.CONSTANT), filter, at);
    }

    /** The relative deviation of the number of rays that land where a part of them does. */
    private static double binomial(double part, long rays) {
        return part == 0 ? 0 : Math.sqrt((1 - part) / part / rays);
    }

    private static Light sun() {
        return new DirectionalLight(Vector3.UNIT_Y.negated(), Color.WHITE, 0);
    }

    private static void disc(NumericCase asked, Checks checks) {
        double height = asked.inputs().number("h");
        double radius = asked.inputs().number("r");
        Scene scene = LitFloor.under(
                height / 2, 0.55 * radius, 2 * radius, new PointLight(new Vector3(0, height, 0), Color.WHITE));
        IlluminationMap.Lookup lookup =
                LightRun.of(scene, LitFloor.within(radius, 1), "random", RAYS).lookup();
        double ratio = LightRun.irradiance(lookup, LitFloor.LIT, 0, 0, 0) * height * height;
        double expected = asked.expected().number("estimate_over_pointwise");
        double part = (double) lookup.photonsUsed() / RAYS;
        checks.statistic("estimate_over_pointwise", expected, ratio, expected * binomial(part, RAYS), SIGMAS);
    }

    private static void mean(NumericCase asked, Checks checks) {
        int maps = (int) asked.inputs().integer("maps");
        long rays = asked.inputs().integer("photons_each");
        int k = (int) asked.inputs().integer("k");
        if (maps < 2 || k < 3 || rays < 20L * k) {
            throw new CaseFault("a deviation needs 2 maps, 3 photons and 20 times as many in all, but there are " + maps
                    + ", " + k + " and " + rays);
        }
        double[] found = new double[maps];
        for (int i = 0; i < maps; i++) {
            Scene scene = LitFloor.under(1, 1, 2, sun());
            IlluminationMap.Lookup lookup = LightRun.of(scene, LitFloor.nearest(k, i + 1), "random", rays)
                    .lookup();
            found[i] = LightRun.irradiance(lookup, LitFloor.LIT, 0, 0, 0);
        }
        double error = Math.sqrt((rays - k + 1.0) / rays / (k - 2) / maps);
        double z = (Sample.of(found).mean() - 1) / error;
        checks.number("z", asked.expected().number("z"), z, asked.tolerance().number("abs_z"));
    }

    private static void slope(NumericCase asked, Checks checks) {
        double[] rays = asked.inputs().numbers("N");
        int repeats = (int) asked.inputs().integer("repeats");
        double random = slope(rays, repeats, "random");
        checks.number(
                "log_rmse_slope_variance_part",
                asked.expected().number("log_rmse_slope_variance_part"),
                random,
                asked.tolerance().number("slope_abs"));
        if (asked.expected().has("with_stratification_2D")) {
            double[] few = Arrays.stream(rays).filter(n -> n <= 1e5).toArray();
            double lattice = slope(few.length < 2 ? rays : few, repeats, "planar");
            checks.note(String.format(
                    Locale.ROOT,
                    "random rays are not stratified; the lattices of 'planar' have a slope of %.2f",
                    lattice));
        }
    }

    private static double slope(double[] rays, int repeats, String preProcessor) {
        if (rays.length < 2 || repeats < 2) {
            throw new CaseFault("a slope needs two numbers of rays, and a deviation two repeats");
        }
        double expected = meanOfDisc();
        SimpleRegression line = new SimpleRegression();
        for (int k = 0; k < rays.length; k++) {
            long passes = Math.max((repeats + POINTS - 1) / POINTS, Math.min(repeats, (long) (MOST_RAYS / rays[k])));
            double squares = 0;
            for (int i = 0; i < passes; i++) {
                // No pass takes up the rays of one with fewer.
                squares += squares((long) rays[k], i * rays.length + k, preProcessor, expected);
            }
            line.addData(StrictMath.log(rays[k]), 0.5 * StrictMath.log(squares / passes));
        }
        return line.getSlope();
    }

    /** The sum of the squares of what the points are off. */
    private static double squares(long rays, long seed, String preProcessor, double expected) {
        Scene scene = LitFloor.under(0.5, 0.35, 1, new PointLight(Vector3.UNIT_Y, Color.WHITE));
        IlluminationMap.Lookup lookup = LightRun.of(scene, LitFloor.within(DISC, seed), preProcessor, rays)
                .lookup();
        double squares = 0;
        for (int i = 0; i < POINTS; i++) {
            double angle = 2 * Math.PI * (i + 0.5) / POINTS;
            double x = FROM_FOOT * StrictMath.cos(angle);
            double z = FROM_FOOT * StrictMath.sin(angle);
            double off = LightRun.irradiance(lookup, LitFloor.LIT, x, 0, z) - expected;
            squares += off * off;
        }
        return squares;
    }

    /** The mean over a point's disc of what a lamp of 1 W/sr at height 1 sends to the floor: (1 + x² + z²)^(−3/2). */
    private static double meanOfDisc() {
        GaussIntegrator nodes = new GaussIntegratorFactory().legendre(20, 0.0, 1.0);
        return nodes.integrate(s -> nodes.integrate(turn -> {
            double radius = DISC * Math.sqrt(s);
            double x = FROM_FOOT + radius * StrictMath.cos(Math.PI * turn);
            double z = radius * StrictMath.sin(Math.PI * turn);
            return StrictMath.pow(1 + x * x + z * z, -1.5);
        }));
    }
}
