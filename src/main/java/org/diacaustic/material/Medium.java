package org.diacaustic.material;

import org.diacaustic.math.Color;

/**
 * What light travels through.
 *
 * @param indexOfRefraction positive; 1 for empty space
 * @param absorption the part of the light lost per scene unit, per colour: after a distance d, exp(−absorption·d) is
 *     left
 * @param priority at least 0; where transparent objects overlap, the one of the highest priority fills the overlap [Schmidt and
 *     Budge 2002, "Simple Nested Dielectrics in Ray Traced Images"]; among equals the one entered last
 */
public record Medium(double indexOfRefraction, Color absorption, int priority) {
    public static final Medium VACUUM = new Medium(1, Color.BLACK, 0);

    public Medium {
        if (!(indexOfRefraction > 0 && indexOfRefraction < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "an index of refraction must be positive and finite, but is " + indexOfRefraction);
        }
        if (!absorption.isFinite() || absorption.smallest() < 0) {
            throw new IllegalArgumentException("absorption must be finite and not negative, but is " + absorption);
        }
        if (priority < 0) {
            throw new IllegalArgumentException("a priority must be at least 0, but is " + priority);
        }
    }

    public static Medium of(double indexOfRefraction) {
        return new Medium(indexOfRefraction, Color.BLACK, 0);
    }

    public boolean absorbs() {
        return !absorption.isBlack();
    }

    /** The fraction of one channel left after a distance. Both may be infinite: nothing of either leaves all. */
    public static double transmittance(double absorption, double distance) {
        return absorption == 0 || distance == 0 ? 1 : StrictMath.exp(-absorption * distance);
    }

    /** The fraction of one channel lost on the way: 1 − {@link #transmittance}, of which the smallest keeps its digits. */
    public static double absorbed(double absorption, double distance) {
        return absorption == 0 || distance == 0 ? 0 : -StrictMath.expm1(-absorption * distance);
    }
}
