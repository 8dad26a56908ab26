package org.diacaustic.math;

/**
 * Three linear channels, red, green and blue. What they measure (a fraction, radiance, irradiance, intensity) is said
 * where the value is declared.
 */
public record Color(double red, double green, double blue) {
    public static final Color BLACK = new Color(0, 0, 0);
    public static final Color WHITE = new Color(1, 1, 1);

    public static Color grey(double value) {
        return new Color(value, value, value);
    }

    public Color times(double factor) {
        return new Color(red * factor, green * factor, blue * factor);
    }

    public Color plus(Color other) {
        return new Color(red + other.red, green + other.green, blue + other.blue);
    }

    public boolean isBlack() {
        return red == 0 && green == 0 && blue == 0;
    }

    public double largest() {
        return Math.max(red, Math.max(green, blue));
    }

    public double smallest() {
        return Math.min(red, Math.min(green, blue));
    }

    public boolean isFinite() {
        return Double.isFinite(red) && Double.isFinite(green) && Double.isFinite(blue);
    }

    /** The luminance of linear sRGB primaries [Rec. ITU-R BT.709]. */
    public double luminance() {
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    }
}
