package org.diacaustic.scenefile;

import java.math.BigDecimal;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.regex.Pattern;
import org.diacaustic.scenefile.Node.Scalar;

/**
 * Numbers as the core schema of YAML 1.2 writes them [YAML 1.2.2, 10.3.2]: {@code 12}, {@code -1.5e3}, {@code .5},
 * {@code 0o17} (octal, 15), {@code 0x1F}, {@code .inf}, {@code .nan}. Quoted text is never a number.
 */
final class NumberText {
    private static final Pattern DECIMAL = Pattern.compile("[-+]?(\\.[0-9]+|[0-9]+(\\.[0-9]*)?)([eE][-+]?[0-9]+)?");
    private static final Pattern BASED = Pattern.compile("0o[0-7]+|0x[0-9a-fA-F]+");
    private static final Pattern INFINITE = Pattern.compile("[-+]?\\.(inf|Inf|INF)");
    private static final Pattern NOT_A_NUMBER = Pattern.compile("\\.(nan|NaN|NAN)");
    private static final Pattern COMMA = Pattern.compile("[-+]?[0-9]+,[0-9]+");
    /** Longer than any exact decimal form of a double that a program writes; keeps conversion fast. */
    private static final int MAX_LENGTH = 1100;

    private NumberText() {}

    /** The number of a slot; nothing after adding a problem that says {@code expected}. */
    static OptionalDouble parse(Slot slot, String expected, boolean infinityAllowed) {
        if (!(slot.node() instanceof Scalar scalar)) {
            slot.unexpected(expected);
            return OptionalDouble.empty();
        }
        String text = scalar.text();
        if (scalar.plain() && text.length() <= MAX_LENGTH) {
            if (DECIMAL.matcher(text).matches()) {
                double value = Double.parseDouble(text);
                if (Double.isInfinite(value)) {
                    return refuse(slot, expected, ", which is too large for a double");
                }
                return OptionalDouble.of(value);
            }
            if (BASED.matcher(text).matches()) {
                return OptionalDouble.of(based(text).doubleValue());
            }
            if (infinityAllowed && INFINITE.matcher(text).matches()) {
                return OptionalDouble.of(text.startsWith("-") ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY);
            }
        }
        return refuse(slot, expected, advice(scalar));
    }

    /** The whole number of a slot; {@code 1e6} is one, {@code 1.5} is not. */
    static OptionalLong parseWhole(Slot slot, String expected) {
        if (slot.node() instanceof Scalar scalar
                && scalar.plain()
                && scalar.text().length() <= MAX_LENGTH) {
            String text = scalar.text();
            try {
                if (BASED.matcher(text).matches()) {
                    return OptionalLong.of(based(text).longValueExact());
                }
                // An exponent beyond a long's is no long, and must not be written out in digits.
                if (DECIMAL.matcher(text).matches() && Math.abs(Double.parseDouble(text)) < 0x1p64) {
                    return OptionalLong.of(new BigDecimal(text).longValueExact());
                }
            } catch (ArithmeticException | NumberFormatException notALong) {
                return refuseWhole(slot, expected, "");
            }
            return refuseWhole(slot, expected, DECIMAL.matcher(text).matches() ? "" : advice(scalar));
        }
        return refuseWhole(slot, expected, slot.node() instanceof Scalar scalar ? advice(scalar) : "");
    }

    static boolean isNumber(Scalar scalar) {
        String text = scalar.text();
        return scalar.plain()
                && text.length() <= MAX_LENGTH
                && (DECIMAL.matcher(text).matches() || BASED.matcher(text).matches());
    }

    private static BigDecimal based(String text) {
        return new BigDecimal(new java.math.BigInteger(text.substring(2), text.charAt(1) == 'o' ? 8 : 16));
    }

    private static String advice(Scalar scalar) {
        String text = scalar.text();
        if (COMMA.matcher(text).matches()) {
            return "; write " + text.replace(',', '.') + ", with a point";
        }
        if (!scalar.plain() && DECIMAL.matcher(text).matches()) {
            return " in quotes, which make it text";
        }
        if (INFINITE.matcher(text).matches() || NOT_A_NUMBER.matcher(text).matches()) {
            return ", which is not a finite number";
        }
        return "";
    }

    private static OptionalDouble refuse(Slot slot, String expected, String advice) {
        slot.error("expected " + expected + ", found " + slot.node().describe() + advice);
        return OptionalDouble.empty();
    }

    private static OptionalLong refuseWhole(Slot slot, String expected, String advice) {
        slot.error("expected " + expected + ", found " + slot.node().describe() + advice);
        return OptionalLong.empty();
    }
}
