package org.diacaustic.chart;

import java.util.Locale;

/** Shapes that tell lines apart where colours do not. All look equally large. */
public enum Mark {
    CIRCLE,
    SQUARE,
    TRIANGLE,
    DIAMOND;

    private static final double SQUARE_SIDE = 0.88;
    private static final double TRIANGLE_HEIGHT = 1.2;
    private static final double DIAMOND_HEIGHT = 1.25;

    /** Its outline in SVG's words. */
    String path(double x, double y, double radius) {
        return switch (this) {
            case CIRCLE ->
                text(
                        "M%.1f %.1fa%.1f %.1f 0 1 0 %.1f 0a%.1f %.1f 0 1 0 %.1f 0z",
                        x - radius, y, radius, radius, 2 * radius, radius, radius, -2 * radius);
            case SQUARE -> {
                double half = SQUARE_SIDE * radius;
                yield text("M%.1f %.1fh%.1fv%.1fh%.1fz", x - half, y - half, 2 * half, 2 * half, -2 * half);
            }
            case TRIANGLE -> {
                double half = TRIANGLE_HEIGHT * radius;
                yield text("M%.1f %.1fl%.1f %.1fh%.1fz", x, y - half, half, 1.8 * half, -2 * half);
            }
            case DIAMOND -> {
                double half = DIAMOND_HEIGHT * radius;
                yield text(
                        "M%.1f %.1fl%.1f %.1fl%.1f %.1fl%.1f %.1fz",
                        x, y - half, half, half, -half, half, -half, -half);
            }
        };
    }

    private static String text(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
