package org.diacaustic.study;

import org.diacaustic.math.Dielectric;

/** Light of unit flux from a point over flat layers, down to a floor: the closed forms of P-RADIOM-04 to 07. */
final class FlatLayers {
    private final double[] thickness;
    private final double[] index;
    private final double transparency;
    private final Dielectric dielectric = new Dielectric();

    /**
     * @param thickness of the layers, from the light down
     * @param index of refraction of each
     * @param transparency what all interfaces together let through, besides Fresnel
     */
    FlatLayers(double[] thickness, double[] index, double transparency) {
        this.thickness = thickness;
        this.index = index;
        this.transparency = transparency;
    }

    /** The irradiance at a lateral distance r > 0: T sin θ ÷ (4π r dr/dθ), θ where the ray starts. */
    double irradiance(double r) {
        double low = 0;
        double high = Math.PI / 2;
        for (int i = 0; i < 60; i++) {
            double middle = (low + high) / 2;
            if (lateral(middle) < r) {
                low = middle;
            } else {
                high = middle;
            }
        }
        double angle = (low + high) / 2;
        double slope = 0;
        double through = transparency;
        for (int i = 0; i < index.length; i++) {
            double cosine = cosine(angle, i);
            slope += thickness[i] * Math.cos(angle) / (index[i] / index[0] * cosine * cosine * cosine);
            if (i > 0) {
                dielectric.evaluate(cosine(angle, i - 1), index[i - 1], index[i]);
                through *= dielectric.transmittance;
            }
        }
        return through * Math.sin(angle) / (4 * Math.PI * r * slope);
    }

    private double lateral(double angle) {
        double sum = 0;
        for (int i = 0; i < index.length; i++) {
            sum += thickness[i] * Math.sin(angle) / (index[i] / index[0] * cosine(angle, i));
        }
        return sum;
    }

    private double cosine(double angle, int layer) {
        double sine = Math.sin(angle) * index[0] / index[layer];
        return Math.sqrt(1 - sine * sine);
    }
}
