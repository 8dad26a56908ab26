package org.diacaustic.math;

/** Three mutable linear channels: what the hot loops sum and scale in place of allocating a {@link Color}. */
public final class Rgb {
    public double red;
    public double green;
    public double blue;

    public Rgb set(double r, double g, double b) {
        red = r;
        green = g;
        blue = b;
        return this;
    }

    public Rgb set(Color color) {
        return set(color.red(), color.green(), color.blue());
    }

    public Rgb set(Rgb other) {
        return set(other.red, other.green, other.blue);
    }

    public Rgb add(double r, double g, double b) {
        red += r;
        green += g;
        blue += b;
        return this;
    }

    public Rgb add(Rgb other) {
        return add(other.red, other.green, other.blue);
    }

    /** Adds a · b, channel by channel. */
    public Rgb addProduct(Rgb a, Rgb b) {
        return add(a.red * b.red, a.green * b.green, a.blue * b.blue);
    }

    public Rgb scale(double factor) {
        red *= factor;
        green *= factor;
        blue *= factor;
        return this;
    }

    public Rgb multiply(double r, double g, double b) {
        red *= r;
        green *= g;
        blue *= b;
        return this;
    }

    public Rgb multiply(Rgb other) {
        return multiply(other.red, other.green, other.blue);
    }

    public boolean isBlack() {
        return red == 0 && green == 0 && blue == 0;
    }

    public double sum() {
        return red + green + blue;
    }

    public double largest() {
        return Math.max(red, Math.max(green, blue));
    }

    public Color toColor() {
        return new Color(red, green, blue);
    }
}
