package org.diacaustic.map;

import java.util.Objects;

/**
 * How ambient maps are made of photons and read.
 *
 * @param expectedCount the photons that a texel is expected to have, for {@link AmbientCalibration#EXPECTED_COUNT}; not a
 *     number: the mean of the texels of the same map that have any, since large and small objects have equally many texels
 * @param blur the side, in texels, of the square over which each texel's light is evened out; odd, or 0 for none
 * @param separatesSides whether the two sides of an object have maps of their own; otherwise what lands on one side is seen
 *     on both
 * @param interpolates whether a lookup goes smoothly from texel to texel; otherwise it takes the texel that it falls into
 */
public record AmbientOptions(
        AmbientCalibration calibration, double expectedCount, int blur, boolean separatesSides, boolean interpolates) {

    /** @throws IllegalArgumentException if the count is not positive, or the blur negative or even but not 0 */
    public AmbientOptions {
        Objects.requireNonNull(calibration, "calibration");
        if (expectedCount <= 0 || expectedCount == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException(
                    "the expected number of photons must be positive and finite, but is " + expectedCount);
        }
        if (blur < 0 || blur != 0 && blur % 2 == 0) {
            throw new IllegalArgumentException("the side of a blur must be 0 or odd, but is " + blur);
        }
    }

    /** Irradiance, blurred over 3 × 3 texels, by side, read smoothly. */
    public static AmbientOptions physical() {
        return new AmbientOptions(AmbientCalibration.DENSITY, Double.NaN, 3, true, true);
    }

    /** As in the thesis: mean power, blurred over 3 × 3 texels, one map for both sides, read texel by texel. */
    public static AmbientOptions thesis() {
        return new AmbientOptions(AmbientCalibration.EXPECTED_COUNT, Double.NaN, 3, false, false);
    }

    public AmbientOptions withBlur(int side) {
        return new AmbientOptions(calibration, expectedCount, side, separatesSides, interpolates);
    }

    public AmbientOptions withExpectedCount(double count) {
        return new AmbientOptions(calibration, count, blur, separatesSides, interpolates);
    }

    public AmbientOptions separatingSides(boolean on) {
        return new AmbientOptions(calibration, expectedCount, blur, on, interpolates);
    }

    public AmbientOptions interpolating(boolean on) {
        return new AmbientOptions(calibration, expectedCount, blur, separatesSides, on);
    }
}
