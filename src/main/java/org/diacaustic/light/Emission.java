package org.diacaustic.light;

import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;

/** The checks that all lights make of what they are given. */
final class Emission {
    private Emission() {}

    static Color checked(Color color, String what) {
        if (!color.isFinite() || color.smallest() < 0) {
            throw new IllegalArgumentException(what + " must be finite and not negative, but is " + color);
        }
        return color;
    }

    static Vector3 checkedPoint(Vector3 point, String what) {
        if (!point.isFinite()) {
            throw new IllegalArgumentException(what + " must be finite, but is " + point);
        }
        return point;
    }

    static double checkedExponent(double exponent) {
        if (!(exponent >= 0 && exponent < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("a highlight exponent must be at least 0, but is " + exponent);
        }
        return exponent;
    }

    static int checkedSamples(int samples) {
        if (samples < 1) {
            throw new IllegalArgumentException("an area light needs at least 1 sample, but has " + samples);
        }
        return samples;
    }
}
