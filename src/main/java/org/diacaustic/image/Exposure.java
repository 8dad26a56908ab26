package org.diacaustic.image;

import java.util.Objects;

/**
 * How radiance is made visible in 8 bits: sRGB of toneMapping(factor × radiance). Formats that hold linear radiance make
 * no use of it.
 *
 * @param factor display value per W·m⁻²·sr⁻¹, positive and finite
 * @param toneMapping what happens near and above 1
 */
public record Exposure(double factor, ToneMapping toneMapping) {
    private static final double SHARE_BELOW_WHITE = 0.99;
    private static final double NEAR_WHITE = 0.9;

    public Exposure {
        if (!(factor > 0 && factor < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("exposure must be positive and finite, but is " + factor);
        }
        Objects.requireNonNull(toneMapping, "toneMapping");
    }

    /**
     * The stated factor; brighter than 1 is cut off.
     *
     * @throws IllegalArgumentException if it is not positive and finite
     */
    public static Exposure fixed(double factor) {
        return new Exposure(factor, ToneMapping.CLIP);
    }

    /**
     * A factor chosen from the image: the luminance that 99 % of the lit pixels do not exceed becomes 0.9, a little below
     * white, so a few very bright pixels (a focus, a highlight) do not darken the picture. Pixels without positive, finite
     * luminance do not count; an image that has no others gives 1. Scaling the image by a power of two scales the
     * factor by its inverse exactly.
     */
    public static Exposure auto(LinearImage image) {
        float[] samples = image.samples();
        float bright = PixelRank.positive(samples.length, offset -> luminance(samples, offset), SHARE_BELOW_WHITE);
        return fixed(bright == 0 ? 1 : NEAR_WHITE / bright);
    }

    /** The same factor with another tone mapping. */
    public Exposure with(ToneMapping mapping) {
        return new Exposure(factor, mapping);
    }

    /** The linear display value in 0..1 of one channel of radiance; not-a-number stays so. */
    public double display(double radiance) {
        return toneMapping.map(factor * radiance);
    }

    /** The sRGB code 0..255 of one channel of radiance; 0 for negative values and not-a-number, 255 for +∞. */
    public int srgb8(double radiance) {
        return SrgbCurve.encodeByte(display(radiance));
    }

    /** As {@code Color.luminance()}, without making a colour. */
    private static float luminance(float[] samples, int offset) {
        return (float) (0.2126 * samples[offset] + 0.7152 * samples[offset + 1] + 0.0722 * samples[offset + 2]);
    }
}
