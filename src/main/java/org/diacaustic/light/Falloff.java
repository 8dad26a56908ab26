package org.diacaustic.light;

/** How the irradiance of a light depends on distance: irradiance on a facing surface = intensity × falloff(distance). */
public sealed interface Falloff {

    /** The factor at a positive distance in scene units. */
    double at(double distance);

    /** d² · falloff(d): what remains of it beside the thinning of rays that nature knows. */
    default double besideSpreading(double distance) {
        return distance * distance * at(distance);
    }

    /** 1 ÷ d²: light as it is. */
    record InverseSquare() implements Falloff {
        @Override
        public double at(double distance) {
            return 1 / (distance * distance);
        }

        @Override
        public double besideSpreading(double distance) {
            return 1;
        }
    }

    /** 1 at any distance: the thesis' lights. */
    record None() implements Falloff {
        @Override
        public double at(double distance) {
            return 1;
        }
    }

    /**
     * 1 ÷ (constant + linear·d + quadratic·d²): the attenuation that many renderers of the thesis' time offer [Thesis
     * 3.2.2].
     */
    record Polynomial(double constant, double linear, double quadratic) implements Falloff {
        public Polynomial {
            if (!(constant >= 0 && linear >= 0 && quadratic >= 0)
                    || !(constant + linear + quadratic > 0)
                    || !(constant + linear + quadratic < Double.POSITIVE_INFINITY)) {
                throw new IllegalArgumentException(
                        "a polynomial falloff needs finite coefficients of at least 0, not all" + " 0, but has "
                                + constant + ", " + linear + ", " + quadratic);
            }
        }

        @Override
        public double at(double distance) {
            return 1 / (constant + distance * (linear + distance * quadratic));
        }
    }
}
