package org.diacaustic.image;

/** How exposure × radiance, 0 and up, becomes a linear display value in 0..1. */
public enum ToneMapping {
    /** As it is; what exceeds 1 is cut off. The default, as in the thesis. */
    CLIP {
        @Override
        public double map(double exposed) {
            return Math.max(0, Math.min(1, exposed));
        }
    },

    /** 1 − exp(−x): the response of film, which nears 1 but never cuts off. */
    EXPONENTIAL {
        @Override
        public double map(double exposed) {
            // The direct form 1 − exp(−x) would lose small values entirely.
            return Math.max(0, -StrictMath.expm1(-exposed));
        }
    };

    /** The display value of exposure × radiance: 0 for negative values, 1 for +∞; not-a-number stays so. */
    public abstract double map(double exposed);
}
