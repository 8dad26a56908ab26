package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.diacaustic.image.LinearImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What theory knows of techniques where light is smooth, found by rendering. Seeds are fixed; bounds are those of chance. */
class KnownTruthsTest {
    private static final SmoothLight LIGHT = new SmoothLight();

    private static Technique known(String name) {
        return Techniques.parse(name).get(0);
    }

    private static PowerFit fit(
            double[] x, DoubleFunction<SmoothLight.Errors> made, ToDoubleFunction<SmoothLight.Errors> y) {
        return PowerFit.of(x, Arrays.stream(x).mapToObj(made).mapToDouble(y).toArray());
    }

    private static String whole(String key, double value) {
        return key + "=" + (long) value;
    }

    @Test
    void density_givenMoreRandomRays_hasAVarianceThatFallsLikeTheirNumber() {
        double[] rays = {1000, 3000, 10_000, 30_000, 100_000};
        PowerFit fit = fit(
                rays,
                n -> LIGHT.errors(known("random-density"), 12, whole("rays", n), "gather-radius=0.15"),
                SmoothLight.Errors::variance);
        // 12 seeds of some 20 kernels side by side: each variance is off by some 9 %.
        assertThat(fit.power()).as("%s", fit).isCloseTo(-1, within(0.07));
    }

    @Test
    void density_givenMoreRays_keepsTheBiasOfItsKernel() {
        double[] rays = {4000, 16_000, 64_000};
        double expected = SmoothLight.squaredBiasOfKernel(0.6);
        for (double n : rays) {
            SmoothLight.Errors errors = LIGHT.errors(known("planar-density"), 4, whole("rays", n), "gather-radius=0.6");
            assertThat(errors.squaredBias()).isCloseTo(expected, withinPercentage(3));
            assertThat(errors.meanSquare()).isCloseTo(expected, withinPercentage(3));
        }
    }

    @Test
    void density_givenWiderRadius_hasASquaredBiasThatGrowsLikeItsFourthPower() {
        double[] radii = {0.15, 0.3, 0.6};
        PowerFit fit = fit(
                radii,
                r -> LIGHT.errors(known("planar-density"), 8, "rays=32000", "gather-radius=" + r),
                SmoothLight.Errors::squaredBias);
        // Irradiance is no parabola: of the widest kernel, as wide as 3/8 of the lamp's height, bias is a little less.
        PowerFit expected = PowerFit.of(
                radii,
                Arrays.stream(radii).map(SmoothLight::squaredBiasOfKernel).toArray());
        assertThat(fit.power())
                .as("%s", fit)
                .isCloseTo(expected.power(), within(0.05))
                .isCloseTo(4, within(0.15));
    }

    @Test
    void progressive_givenMorePasses_hasAnErrorThatFallsLikeTheirCubeRoot() {
        double[] passes = {6, 18, 54, 108};
        PowerFit fit = fit(
                passes,
                m -> LIGHT.errors(known("random-progressive"), 12, "rays=200", whole("passes", m), "gather-radius=0.6"),
                SmoothLight.Errors::meanSquare);
        assertThat(fit.power()).as("%s", fit).isCloseTo(-2.0 / 3, within(0.08));
    }

    @Test
    void progressive_givenMorePasses_hasASquaredBiasThatFallsAsItsVariance() {
        double[] passes = {30, 90, 270};
        PowerFit fit = fit(
                passes,
                m -> LIGHT.errors(known("planar-progressive"), 3, "rays=400", whole("passes", m), "gather-radius=0.6"),
                SmoothLight.Errors::squaredBias);
        assertThat(fit.power()).as("%s", fit).isCloseTo(-2.0 / 3, within(0.08));
    }

    @Test
    void lightTracing_givenMoreRandomRays_hasAnErrorThatFallsLikeTheRootOfTheirNumber() {
        double[] rays = {1000, 4000, 16_000, 64_000};
        PowerFit fit = fit(rays, n -> LIGHT.errors(traced((long) n, 1, 10)), errors -> Math.sqrt(errors.meanSquare()));
        // 10 seeds of 64 pixels: each error is off by some 3 %.
        assertThat(fit.power()).as("%s", fit).isCloseTo(-0.5, within(0.03));
    }

    private static List<LinearImage> traced(long rays, int firstSeed, int seeds) {
        return IntStream.range(firstSeed, firstSeed + seeds)
                .mapToObj(seed -> LIGHT.traced(rays, seed))
                .toList();
    }

    @Test
    void meanInterval_givenRunsOfLightTracing_containsTheTruthAsOftenAsItSays() {
        int trials = 100;
        int seeds = 5;
        SmoothLight.Errors all = LIGHT.errors(traced(500, 1, trials * seeds));
        long hits = IntStream.range(0, trials)
                .mapToObj(i -> Arrays.copyOfRange(all.brightness(), i * seeds, (i + 1) * seeds))
                .filter(runs -> Distribution.of(runs).meanInterval().contains(0))
                .count();
        // 95 of 100, and three standard deviations of 2.2.
        assertThat(hits).isBetween(89L, 100L);
    }

    @ParameterizedTest
    @ValueSource(strings = {"caustic-mesh", "planar-caustic-mesh", "cube-caustic-mesh", "adaptive-caustic-mesh"})
    void causticMesh_givenMoreRays_hasAnErrorThatFallsLikeTheirNumber(String name) {
        double[] rays = {500, 2000, 8000};
        PowerFit fit = fit(
                rays,
                n -> LIGHT.errors(known(name), 2, whole("rays", n), "samples=100"),
                errors -> Math.sqrt(errors.meanSquare()));
        assertThat(fit.power()).as("%s", fit).isLessThan(-0.9);
    }

    private static Stream<Technique> calibrated() {
        return Techniques.known().stream()
                .filter(technique -> !List.of("light-tracing", "caustic-mesh", "expected-count")
                        .contains(technique.family()));
    }

    /** Wide kernels and texels of a pixel may take up to 1 % of the light: it is brightest in the middle. */
    @ParameterizedTest
    @MethodSource("calibrated")
    void render_givenCalibratedTechnique_convergesToTheExactPicture(Technique technique) {
        SmoothLight.Errors few = errors(technique, 4000);
        SmoothLight.Errors many = errors(technique, 32_000);
        assertThat(Math.abs(many.meanBrightness())).isLessThan(0.01 + 3 * many.standardError());
        // 4/3 ÷ 50: what a fixed number of random photons leaves to chance, however many there are.
        double chance = technique.family().equals("nearest") ? 4.0 / 3 / 50 : 0;
        double bias = 0.01 * 0.01;
        assertThat(many.meanSquare()).isLessThan(Math.max(Math.max(bias, chance), 0.5 * few.meanSquare()));
    }

    private static SmoothLight.Errors errors(Technique technique, int rays) {
        int passes = technique.raysAPass() > 0 ? 16 : 1;
        boolean hasRadius = List.of("density", "progressive", "expected-count").contains(technique.family());
        return LIGHT.errors(
                technique,
                5,
                "rays=" + rays / passes,
                "passes=" + passes,
                hasRadius ? "gather-radius=0.2" : "samples=4");
    }

    @ParameterizedTest
    @ValueSource(strings = {"random", "monte-carlo", "planar", "cube", "adaptive"})
    void expectedCount_givenMoreRays_staysTooBright(String preProcessor) {
        Technique technique = known(preProcessor + "-expected-count");
        for (int rays : new int[] {4000, 32_000}) {
            double brightness = errors(technique, rays).meanBrightness();
            assertThat(brightness)
                    .as("mean error of %s with %d rays", technique.name(), rays)
                    .isGreaterThan(0.2);
        }
    }
}
