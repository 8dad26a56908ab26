package org.diacaustic.page;

import java.math.BigDecimal;
import java.util.Locale;
import java.util.function.DoubleFunction;
import org.diacaustic.study.Budget;
import org.diacaustic.study.Interval;

/** Numbers as people read them: three digits or so, with their unit; a dash where there is none. */
final class Numbers {
    private static final String NONE = "–";
    private static final String SPACE = "\u00a0";
    private static final String SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    private static final double LARGE = 1e6;

    private Numbers() {}

    /** A fraction as a percentage. */
    static String percent(double fraction) {
        return Double.isFinite(fraction) ? digits(100 * fraction) + SPACE + "%" : NONE;
    }

    /** A fraction as a percentage with two digits after the point, and with its sign even if that is a plus. */
    static String signedPercent(double fraction) {
        if (!Double.isFinite(fraction)) {
            return NONE;
        }
        String digits = text("%+.2f", 100 * fraction);
        return (digits.matches("[+-]0\\.00") ? "0" : digits.replace('-', '−')) + SPACE + "%";
    }

    /** A round fraction as a percentage, with nothing that it does not need. */
    static String roundPercent(double fraction) {
        return tick(Math.rint(1e9 * fraction) / 1e7) + SPACE + "%";
    }

    static String seconds(double seconds) {
        if (!Double.isFinite(seconds)) {
            return NONE;
        }
        return seconds < 0.0995 && seconds > 0 ? digits(1000 * seconds) + SPACE + "ms" : digits(seconds) + SPACE + "s";
    }

    static String bytes(double bytes) {
        return scaled(bytes, "B", "kB", "MB", "GB");
    }

    /** A large number, short: 12.3 million. */
    static String count(double count) {
        if (count < LARGE) {
            return Double.isFinite(count) ? text("%,.0f", count) : NONE;
        }
        return scaled(count, "", "thousand", "million", "billion");
    }

    /** What a picture may cost. */
    static String budget(Budget budget) {
        return budget instanceof Budget.Rays rays ? count(rays.count()) + " rays" : budget.label();
    }

    /** A round count at an axis. */
    static String roundCount(double count) {
        return count < LARGE ? count(count) : count(count).replaceFirst("\\.0+(?=" + SPACE + ")", "");
    }

    /** A round number of bytes at an axis. */
    static String roundBytes(double bytes) {
        return bytes(bytes).replaceFirst("\\.0+(?=" + SPACE + ")", "");
    }

    private static String scaled(double value, String... units) {
        if (!Double.isFinite(value)) {
            return NONE;
        }
        double rest = value;
        int unit = 0;
        while (rest >= 999.5 && unit + 1 < units.length) {
            rest /= 1000;
            unit++;
        }
        return digits(rest) + (units[unit].isEmpty() ? "" : SPACE + units[unit]);
    }

    /** A power of a slope. */
    static String power(double power) {
        // Added to 0, −0 is 0.
        double rounded = Math.rint(100 * power) / 100 + 0.0;
        return Double.isFinite(power) ? text("%.2f", rounded).replace('-', '−') : NONE;
    }

    /** From low to high in the words that one number has; a dash if nothing is known. */
    static String interval(Interval interval, DoubleFunction<String> words) {
        return Double.isFinite(interval.low())
                ? words.apply(interval.low()) + " to " + words.apply(interval.high())
                : NONE;
    }

    /** Three digits that count, without those after the point that a large number does not need. */
    static String digits(double value) {
        double size = Math.abs(value);
        if (size == 0) {
            return "0";
        }
        if (size >= 99.95) {
            return text("%,.0f", value);
        }
        if (size >= 9.995) {
            return text("%.1f", value);
        }
        if (size >= 0.9995) {
            return text("%.2f", value);
        }
        int places = Math.min(12, 1 - (int) Math.floor(Math.log10(size)));
        return size < 1e-9 ? text("%.1e", value) : text("%." + places + "f", value);
    }

    /** A round number at an axis, with nothing that it does not need. */
    static String tick(double value) {
        return new BigDecimal(Double.toString(value)).stripTrailingZeros().toPlainString();
    }

    /** A power of ten at an axis, or 2 or 5 times one. */
    static String scientific(double value) {
        int exponent = (int) Math.floor(Math.log10(value) + 1e-9);
        long factor = Math.round(value / Math.pow(10, exponent));
        StringBuilder raised = new StringBuilder(factor == 1 ? "10" : factor + "·10");
        String power = Integer.toString(exponent);
        power.chars().forEach(c -> raised.append(c == '-' ? '⁻' : SUPERSCRIPTS.charAt(c - '0')));
        return raised.toString();
    }

    private static String text(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
