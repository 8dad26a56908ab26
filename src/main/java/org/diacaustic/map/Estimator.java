package org.diacaustic.map;

/**
 * How irradiance is found from the photons near a point: a description, to be carried out by a {@link PhotonMap}. Balls
 * are closed: photons at exactly the radius count.
 */
public sealed interface Estimator {
    /**
     * The weighted powers within a radius ÷ the area of its disc.
     *
     * @param radius in scene units, positive and finite
     */
    record Density(double radius, Kernel kernel) implements Estimator {
        public Density {
            requirePositive("gather radius", radius);
        }
    }

    /**
     * The weighted powers of the k − 1 nearest photons ÷ the area of the disc that reaches to the k-th. The k-th itself
     * gives only the radius: with its power the estimate would be too large by 1 ÷ (k − 1) [García et al. 2012]. Where
     * fewer than k are within the largest radius, this is {@link Density} with that radius.
     *
     * @param count k, at least 2
     * @param maximumRadius in scene units, positive; may be infinite, which gives 0 where there are fewer than k
     */
    record Nearest(int count, double maximumRadius, Kernel kernel) implements Estimator {
        public Nearest {
            if (count < 2) {
                throw new IllegalArgumentException("nearest photons must be at least 2, but are " + count);
            }
            if (!(maximumRadius > 0)) {
                throw new IllegalArgumentException("a largest radius must be positive, but is " + maximumRadius);
            }
        }
    }

    /**
     * The calibration of the thesis: the powers within a radius ÷ the number of photons expected there, whatever the
     * area [Thesis 4.8]. Its unit is that of power.
     *
     * @param radius in scene units, positive and finite
     * @param expectedCount positive and finite
     */
    record ExpectedCount(double radius, double expectedCount) implements Estimator {
        public ExpectedCount {
            requirePositive("gather radius", radius);
            requirePositive("expected number of photons", expectedCount);
        }
    }

    /**
     * The radius for {@link Density} of one pass of many, whose results are averaged, so that variance and squared bias shrink
     * alike: with α = 2/3 [Knaus and Zwicker 2011, Eq. 16].
     *
     * @param firstRadius of pass 1
     * @param pass from 1 on
     */
    static double progressiveRadius(double firstRadius, int pass) {
        return progressiveRadius(firstRadius, pass, 2.0 / 3);
    }

    /**
     * The radius of a pass: r²ᵢ₊₁ = r²ᵢ (i + α) ÷ (i + 1).
     *
     * @param pass from 1 on: a whole number, but small radii lie beyond what fits in one
     * @param alpha from 0 to 1: how much of the variance each pass takes away, the bias being left the rest
     */
    static double progressiveRadius(double firstRadius, double pass, double alpha) {
        requirePositive("first radius", firstRadius);
        if (!(pass >= 1 && pass < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("passes count from 1, but this is " + pass);
        }
        if (!(alpha >= 0 && alpha <= 1)) {
            throw new IllegalArgumentException("alpha of a radius must be from 0 to 1, but is " + alpha);
        }
        double ratioSquared = 1;
        for (int i = 1; i < Math.min(pass, GammaQuotient.ASYMPTOTIC); i++) {
            ratioSquared *= (i + alpha) / (i + 1);
        }
        if (pass > GammaQuotient.ASYMPTOTIC) {
            ratioSquared *= GammaQuotient.fromAsymptotic(pass, alpha);
        }
        return firstRadius * Math.sqrt(ratioSquared);
    }

    private static void requirePositive(String what, double value) {
        if (!(value > 0 && value < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("a " + what + " must be positive and finite, but is " + value);
        }
    }
}
