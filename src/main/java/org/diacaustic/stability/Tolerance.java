package org.diacaustic.stability;

import java.math.BigDecimal;

/**
 * How far off a number may be.
 *
 * @param pass the error that a backward-stable algorithm keeps within
 * @param stretch the error that a careful one keeps within; not a number if the case names none
 */
public record Tolerance(double pass, double stretch) {
    /** The relative error that is allowed where a case says nothing of it. */
    private static final double UNSAID = 1e-12;

    public static Tolerance of(double pass) {
        return new Tolerance(pass, Double.NaN);
    }

    /**
     * What a case says of a quantity: {@code stem_abs} + {@code stem_rel} · |expected|, either of which may be missing, and
     * {@code stretch_stem_abs} and the like; else what it says of all its numbers, {@code abs} and {@code rel}; {@code exact}
     * means the nearest double.
     */
    static Tolerance of(Values said, String stem, BigDecimal expected) {
        String own = said(said, stem + "_") ? stem + "_" : "";
        double size = expected.abs().doubleValue();
        double stretch = sum(said, size, "stretch_" + own + "abs", "stretch_" + own + "rel");
        if (Double.isNaN(stretch)) {
            stretch = sum(said, size, own + "abs_stretch", own + "rel_stretch");
        }
        double pass = sum(said, size, own + "abs", own + "rel");
        if (Double.isNaN(pass)) {
            pass = sum(said, size, own + "abs_each", own + "rel_required");
        }
        if (Double.isNaN(pass)) {
            pass = otherwise(said, size, stretch);
        }
        return new Tolerance(pass, stretch);
    }

    private static double otherwise(Values said, double size, double stretch) {
        if (said.has("exact")) {
            return 0.5 * Math.ulp(size);
        }
        return Double.isNaN(stretch) ? UNSAID * size : Math.max(stretch, UNSAID * size);
    }

    private static boolean said(Values said, String stem) {
        return said.keys().stream()
                .anyMatch(key -> key.startsWith(stem + "abs")
                        || key.startsWith(stem + "rel")
                        || key.startsWith("stretch_" + stem));
    }

    /** Not a number if neither is given. */
    private static double sum(Values said, double size, String absolute, String relative) {
        if (!said.has(absolute) && !said.has(relative)) {
            return Double.NaN;
        }
        return said.number(absolute, 0) + said.number(relative, 0) * size;
    }
}
