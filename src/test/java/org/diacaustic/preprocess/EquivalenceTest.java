package org.diacaustic.preprocess;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.diacaustic.light.Falloff;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.map.Kernel;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The control scene's claim [Thesis 5.3]: a sheet that does not bend light lights the floor through it exactly as straight
 * shadow rays do. Photons gathered over a disc must agree with the mean of that over the disc, whatever chose the rays; the
 * means of independent passes are held to it in units of their own standard error.
 */
class EquivalenceTest {
    private static final int SEEDS = 24;
    private static final double REACH = 0.25;

    /** Where the floor is asked: in the middle, near an edge of the sheet's light, on an edge, at a corner. */
    private static final double[][] PLACES = {
        {0.1, 0.2}, {2.5, 0.3}, {-1.7, -2.2}, {2.85, 0.1}, {2.8, 2.95}, {-2.9, 1.2}
    };

    /** Half the side of a floor that has one, and the texels along it. */
    private static final double FLOOR_HALF = 6;

    private static final int FLOOR_TEXELS = 36;

    private static final Vector3 LAMP = new Vector3(0.3, 12, -0.2);

    /** The lamp, at height 12, is of intensity 1; the sheet at height 4 is 4 × 4 and lets 0.9 through. */
    private static double straight(double x, double z, Vector3 lamp, Falloff falloff) {
        double dx = lamp.x() - x;
        double dz = lamp.z() - z;
        double distance = Math.sqrt(dx * dx + 144 + dz * dz);
        boolean throughTheSheet = Math.abs(x + dx / 3) <= 2 && Math.abs(z + dz / 3) <= 2;
        return throughTheSheet ? 0.9 * 12 / distance * falloff.at(distance) : 0;
    }

    /** The mean over the disc, the sum of so many points that the rest is far below the standard error of the photons. */
    private static double straightOverDisc(double[] at, Vector3 lamp, Falloff falloff) {
        int steps = 400;
        double sum = 0;
        int count = 0;
        for (int i = 0; i < steps * steps; i++) {
            double a = 2 * (i % steps + 0.5) / steps - 1;
            double b = 2 * (i / steps + 0.5) / steps - 1;
            if (a * a + b * b <= 1) {
                sum += straight(at[0] + a * REACH, at[1] + b * REACH, lamp, falloff);
                count++;
            }
        }
        return sum / count;
    }

    private static double[][] gathered(Scene scene, Settings settings, String preProcessor, double[][] places) {
        double[][] found = new double[SEEDS][places.length];
        Workers workers = new Workers(2);
        for (int seed = 0; seed < SEEDS; seed++) {
            Settings seeded = settings.toBuilder().seed(1000 + seed).build();
            ForwardPlan plan = Forward.plan(scene, seeded, preProcessor, 30_000);
            ForwardPass pass = new ForwardPass(plan, 0, workers).run();
            IlluminationMap.Lookup lookup = new MapBuilder(plan, workers)
                    .build(Forward.camera(), pass.photons(), 0)
                    .lookup();
            for (int i = 0; i < places.length; i++) {
                Rgb irradiance = new Rgb();
                lookup.irradiance(onTheFloor(places[i]), irradiance);
                found[seed][i] = irradiance.green;
            }
        }
        return found;
    }

    private static SurfacePoint onTheFloor(double[] at) {
        SurfacePoint point = new SurfacePoint();
        point.x = at[0];
        point.z = at[1];
        point.normalY = 1;
        point.front = true;
        return point;
    }

    /** (mean − expected) in standard errors of the mean, at each place. */
    private static List<Double> scores(double[][] found, ToDoubleFunction<double[]> expected) {
        List<Double> scores = new ArrayList<>();
        for (int i = 0; i < PLACES.length; i++) {
            double mean = 0;
            for (double[] seed : found) {
                mean += seed[i] / SEEDS;
            }
            double variance = 0;
            for (double[] seed : found) {
                variance += (seed[i] - mean) * (seed[i] - mean) / (SEEDS - 1);
            }
            scores.add((mean - expected.applyAsDouble(PLACES[i])) / Math.sqrt(variance / SEEDS));
        }
        return scores;
    }

    private static MapSettings.Builder constantKernel() {
        return MapSettings.builder()
                .kernel(Kernel.CONSTANT)
                .estimator(EstimatorName.DENSITY)
                .gatherRadius(REACH);
    }

    /** With 24 seeds a score is Student's t of 23 degrees of freedom: beyond 5 once in 20,000 times. */
    @ParameterizedTest(name = "{0}, falloff {1}")
    @CsvSource({
        "random, none", "monte-carlo, none", "planar, none", "cube, none", "own-map, none", "adaptive, none",
        "random, nature", "monte-carlo, nature", "planar, nature", "cube, nature", "own-map, nature",
                "adaptive, nature",
    })
    void gather_givenSheetThatDoesNotBend_agreesWithStraightShadowRays(String preProcessor, String law) {
        Falloff falloff = law.equals("none") ? new Falloff.None() : new Falloff.InverseSquare();
        Settings settings =
                Settings.physical().toBuilder().maps(constantKernel().build()).build();
        double[][] found = gathered(Forward.sheetOverFloor(LAMP, falloff), settings, preProcessor, PLACES);
        assertThat(scores(found, at -> straightOverDisc(at, LAMP, falloff)))
                .allSatisfy(score -> assertThat(score).isBetween(-5.0, 5.0));
    }

    /** Maps of the floor's own, unblurred, against the mean of straight light over the texel. */
    @ParameterizedTest(name = "{0}, falloff {1}")
    @CsvSource({
        "random, none", "monte-carlo, none", "planar, none", "cube, none", "adaptive, none",
        "random, nature", "monte-carlo, nature", "planar, nature", "cube, nature", "adaptive, nature",
    })
    void ambientMap_givenSheetThatDoesNotBend_agreesWithStraightShadowRays(String preProcessor, String law) {
        Falloff falloff = law.equals("none") ? new Falloff.None() : new Falloff.InverseSquare();
        Settings settings = Settings.physical().toBuilder()
                .maps(MapSettings.builder()
                        .map(MapName.AMBIENT_MAPS)
                        .mapColumns(FLOOR_TEXELS)
                        .mapRows(FLOOR_TEXELS)
                        .mapBlur(1)
                        .interpolateTexels(false)
                        .build())
                .build();
        Scene scene = Forward.sheetOver(Forward.square(0, FLOOR_HALF), LAMP, falloff);
        double[][] found = gathered(scene, settings, preProcessor, PLACES);
        List<Double> scores = scores(found, at -> straightOverTexel(at, falloff));
        assertThat(scores).allSatisfy(score -> assertThat(score).isBetween(-5.0, 5.0));
    }

    /** The texels of the floor's map are squares along its edges. */
    private static double straightOverTexel(double[] at, Falloff falloff) {
        double side = 2 * FLOOR_HALF / FLOOR_TEXELS;
        double left = Math.floor((at[0] + FLOOR_HALF) / side) * side - FLOOR_HALF;
        double near = Math.floor((at[1] + FLOOR_HALF) / side) * side - FLOOR_HALF;
        int steps = 400;
        double sum = 0;
        for (int i = 0; i < steps * steps; i++) {
            double x = left + side * (i % steps + 0.5) / steps;
            double z = near + side * (i / steps + 0.5) / steps;
            sum += straight(x, z, LAMP, falloff);
        }
        return sum / steps / steps;
    }

    /** Random directions of the thesis, crowded to the corners of a cube, are right with their true density. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void gather_givenDirectionsOverTheWholeSphere_agreesAllTheSame(boolean uniform) {
        Falloff falloff = new Falloff.None();
        Settings settings = Forward.settings(s -> s.aimAtSpecular(false).uniformDirections(uniform)).toBuilder()
                .maps(constantKernel().build())
                .build();
        double[][] found = gathered(Forward.sheetOverFloor(LAMP, falloff), settings, "random", PLACES);
        assertThat(scores(found, at -> straightOverDisc(at, LAMP, falloff)))
                .allSatisfy(score -> assertThat(score).isBetween(-5.0, 5.0));
    }

    /**
     * The thesis' photons without weights, calibrated by their own mean over the places: the expected count makes up for
     * what is alike everywhere only. Batches lie where they were luckier, and steps on a cube or directions out of one are
     * of different size in front of it and at its edges: the lamp stands so that the sheet is seen over one.
     */
    @ParameterizedTest
    @ValueSource(strings = {"random", "monte-carlo", "cube", "adaptive"})
    void gather_givenRaysWithoutWeights_doesNotAgree(String preProcessor) {
        Falloff falloff = new Falloff.None();
        Vector3 lamp = new Vector3(-8, 12, -0.2);
        Settings settings = Settings.thesis().toBuilder()
                .forward(Settings.thesis().forward().toBuilder()
                        .rays(200_000)
                        .baseRays(4000)
                        .batchRays(100)
                        .latticeSize(150)
                        .splitDepth(1)
                        .build())
                .maps(MapSettings.builder()
                        .filterSides(false)
                        .estimator(EstimatorName.EXPECTED_COUNT)
                        .gatherRadius(REACH)
                        .expectedCount(1)
                        .build())
                .build();
        double[][] places = {{1.3, 0.1}, {4, 0.1}, {6.5, 0.1}};
        double[] ratios =
                ratios(places, gathered(Forward.sheetOverFloor(lamp, falloff), settings, preProcessor, places), lamp);
        assertThat(Arrays.stream(ratios).max().getAsDouble()
                        / Arrays.stream(ratios).min().getAsDouble())
                .isGreaterThan(1.15);
        // With weights it does.
        Settings weighted = Settings.physical().toBuilder()
                .forward(ForwardSettings.builder().rays(200_000).build())
                .maps(constantKernel().build())
                .build();
        double[] right =
                ratios(places, gathered(Forward.sheetOverFloor(lamp, falloff), weighted, preProcessor, places), lamp);
        for (double ratio : right) {
            assertThat(ratio).isCloseTo(1, within(0.05));
        }
    }

    /** The mean over the seeds ÷ what is right, at each place. */
    private static double[] ratios(double[][] places, double[][] found, Vector3 lamp) {
        double[] ratios = new double[places.length];
        for (int i = 0; i < places.length; i++) {
            for (double[] seed : found) {
                ratios[i] += seed[i] / SEEDS / straightOverDisc(places[i], lamp, new Falloff.None());
            }
        }
        return ratios;
    }
}
