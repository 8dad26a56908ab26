package org.diacaustic.map;

/** Γ(n + α) ÷ Γ(n + 1) for numbers that are too large for factors to be multiplied one by one. */
final class GammaQuotient {
    /** From here on the asymptotic series is right to rounding after two terms. */
    static final int ASYMPTOTIC = 1 << 12;

    private GammaQuotient() {}

    /**
     * The quotient at n ÷ that at {@link #ASYMPTOTIC}: w^(α − 1) (1 − α(1 − α)(2 − α) ÷ 24w² + …), w = n + α/2 [Tricomi and
     * Erdélyi 1951].
     *
     * @param alpha from 0 to 1
     */
    static double fromAsymptotic(double n, double alpha) {
        double w = n + alpha / 2;
        double first = ASYMPTOTIC + alpha / 2;
        return StrictMath.pow(w / first, alpha - 1) * (1 - second(w, alpha)) / (1 - second(first, alpha));
    }

    private static double second(double w, double alpha) {
        return alpha * (1 - alpha) * (2 - alpha) / 24 / w / w;
    }
}
