package org.diacaustic.study;

import java.util.OptionalDouble;
import java.util.Set;

/**
 * What theory expects of a technique with more and more light rays N, where light is smooth and surfaces are flat. At edges and
 * folds of the light, bias falls slower than said here, or not at all.
 *
 * @param errorPower of N, by which the root mean square error falls; 0 if it stays, empty if theory names no power
 * @param variancePower of N, by which the variance of a picture falls
 * @param squaredBiasPower of N, by which the squared bias falls; empty too if there is none
 * @param says a sentence or two
 */
public record Expectation(
        OptionalDouble errorPower, OptionalDouble variancePower, OptionalDouble squaredBiasPower, String says) {
    private static final OptionalDouble UNKNOWN = OptionalDouble.empty();

    private static final Set<String> INDEPENDENT_RAYS = Set.of("random", "monte-carlo");

    private static final int USUAL_COUNT = 50;

    /** What is expected of a technique, by {@link Technique#family()}, pre-processor and settings. */
    public static Expectation of(Technique technique) {
        boolean byChance = INDEPENDENT_RAYS.contains(technique.preProcessor());
        Expectation random = ofRandomRays(technique);
        if (byChance || technique.family().equals("caustic-mesh")) {
            return random;
        }
        OptionalDouble error = random.squaredBiasPower.equals(OptionalDouble.of(0)) ? random.errorPower : UNKNOWN;
        return new Expectation(
                error,
                UNKNOWN,
                random.squaredBiasPower,
                random.says + " Rays of a lattice have less chance in them than random ones.");
    }

    private static Expectation ofRandomRays(Technique technique) {
        return switch (technique.family()) {
            case "light-tracing" ->
                expect(-0.5, -1, UNKNOWN, "Unbiased: nothing but chance, which falls like N^-1/2 [Arvo 1986].");
            case "density" ->
                expect(
                        0,
                        -1,
                        OptionalDouble.of(0),
                        "Variance falls like 1/N. The bias of the fixed radius r stays; its square grows like r^4"
                                + " [Silverman 1986].");
            case "progressive" -> progressive(technique);
            case "nearest" -> nearest(technique);
            case "expected-count" ->
                expect(
                        0,
                        -1,
                        OptionalDouble.of(0),
                        "Biased: divides by the photons expected, not by the area, so it is as far off with any N"
                                + " [Thesis 4.5].");
            case "ambient-maps" -> ambientMaps(technique);
            case "caustic-mesh" ->
                new Expectation(
                        OptionalDouble.of(-1),
                        UNKNOWN,
                        OptionalDouble.of(-2),
                        "Cells are flat pieces of smooth light: their error falls like their area, 1/N; -0.9 or steeper at"
                                + " edges of the light.");
            default -> new Expectation(UNKNOWN, UNKNOWN, UNKNOWN, "The plan chooses: no expectation.");
        };
    }

    private static Expectation progressive(Technique technique) {
        if (technique.raysAPass() == 0) {
            return expect(
                    0,
                    -1,
                    OptionalDouble.of(0),
                    "With a fixed number of passes the radius shrinks no further: as fixed radius.");
        }
        double fall = -2.0 / 3;
        return expect(
                fall / 2,
                fall,
                OptionalDouble.of(fall),
                "The radius shrinks from pass to pass so that variance and squared bias both fall like N^-2/3: the error"
                        + " like N^-1/3 [Knaus and Zwicker 2011].");
    }

    private static Expectation nearest(Technique technique) {
        int count = Integer.parseInt(technique.settings().getOrDefault("gather-count", "" + USUAL_COUNT));
        // Of the kernel 1 − (d/r)² on a disc, mean square ÷ squared mean is 4/3.
        long percent = Math.round(100 * Math.sqrt(4.0 / 3 / count));
        return expect(
                0,
                0,
                OptionalDouble.of(-2),
                "Reaches as far as " + count
                        + " photons: the nearer they are, the less the bias, but their chance stays, about "
                        + percent
                        + " % of what is seen [Jensen 1996]. With a reach below a pixel, what a few eye rays miss of"
                        + " it is left.");
    }

    private static Expectation ambientMaps(Technique technique) {
        if (technique.settings().getOrDefault("estimator", "density").equals("expected-count")) {
            return expect(0, -1, OptionalDouble.of(0), "Biased, as all that divides by an expected number of photons.");
        }
        return new Expectation(
                UNKNOWN,
                UNKNOWN,
                UNKNOWN,
                "A histogram of 3 x 3 texels: while texels shrink with N, down to the size of a pixel, bias falls and"
                        + " about 4 photons a texel leave a sixth to chance; then variance falls like 1/N and a blur of about"
                        + " a pixel stays [Thesis 4.4].");
    }

    private static Expectation expect(double error, double variance, OptionalDouble squaredBias, String says) {
        return new Expectation(OptionalDouble.of(error), OptionalDouble.of(variance), squaredBias, says);
    }
}
