package org.diacaustic.scenefile;

import java.nio.charset.StandardCharsets;

/** Words and numbers of a text mesh, taken from its bytes one after another; knows the line it is at. */
final class MeshText {
    /** Powers of ten that are exact doubles. */
    private static final double[] EXACT_POWERS = {
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19,
        1e20, 1e21, 1e22
    };

    private final byte[] bytes;
    private int position;
    private int line = 1;
    private int start;
    private int end;

    MeshText(byte[] bytes) {
        this.bytes = bytes;
    }

    int line() {
        return line;
    }

    /** The offset of what comes next. */
    int position() {
        return position;
    }

    /** Moves to the next word of this line; false if there is none. */
    boolean nextWord() {
        while (position < bytes.length && isBlank(bytes[position])) {
            if (bytes[position] == '\\') {
                int newline = position + 1;
                newline += newline < bytes.length && bytes[newline] == '\r' ? 1 : 0;
                if (newline >= bytes.length || bytes[newline] != '\n') {
                    break;
                }
                line++;
                position = newline;
            }
            position++;
        }
        start = position;
        while (position < bytes.length && bytes[position] != '\n' && !isBlank(bytes[position])) {
            position++;
        }
        end = position;
        return end > start;
    }

    /** A backslash counts as blank, because before a line's end it joins the next line to it. */
    private static boolean isBlank(byte b) {
        return b == ' ' || b == '\t' || b == '\r' || b == '\\';
    }

    /** Moves to the start of the next line; false at the end of the text. */
    boolean nextLine() {
        while (position < bytes.length && bytes[position] != '\n') {
            position++;
        }
        if (position == bytes.length) {
            return false;
        }
        position++;
        line++;
        return position < bytes.length;
    }

    /** Moves to the next word on this line or a later one; false at the end of the text. */
    boolean nextWordAnywhere() {
        while (!nextWord()) {
            if (!nextLine()) {
                return false;
            }
        }
        return true;
    }

    /** Goes back to the start of the current word. */
    void back() {
        position = start;
    }

    int length() {
        return end - start;
    }

    byte at(int index) {
        return bytes[start + index];
    }

    boolean is(String ascii) {
        if (ascii.length() != length()) {
            return false;
        }
        for (int i = 0; i < ascii.length(); i++) {
            if (ascii.charAt(i) != bytes[start + i]) {
                return false;
            }
        }
        return true;
    }

    String word() {
        return new String(bytes, start, length(), StandardCharsets.UTF_8);
    }

    /** The next number of this line, which is finite. */
    double number(String what) {
        if (!nextWord()) {
            throw fault("expected " + what + ", a number, found the end of the line");
        }
        return numberHere(what);
    }

    /** The current word as a number, which is finite. */
    double numberHere(String what) {
        double value = fastNumber();
        if (Double.isNaN(value)) {
            value = slowNumber();
        }
        if (!Double.isFinite(value)) {
            throw fault("expected " + what + ", a finite number, found '" + Problem.printable(word(), 40) + "'");
        }
        return value;
    }

    /** Digits, point and exponent while the result is surely rounded right [Clinger 1990]; else NaN. */
    private double fastNumber() {
        int i = start;
        boolean negative = bytes[i] == '-';
        i += negative || bytes[i] == '+' ? 1 : 0;
        long digits = 0;
        int count = 0;
        int scale = 0;
        boolean point = false;
        for (; i < end; i++) {
            byte b = bytes[i];
            if (b >= '0' && b <= '9') {
                digits = 10 * digits + (b - '0');
                scale -= point ? 1 : 0;
                if (++count > 18) {
                    return Double.NaN;
                }
            } else if (b == '.' && !point) {
                point = true;
            } else {
                break;
            }
        }
        if (i < end && count > 0 && (bytes[i] == 'e' || bytes[i] == 'E') && end - i <= 5) {
            int sign = i + 1 < end && bytes[i + 1] == '-' ? -1 : 1;
            i += i + 1 < end && (bytes[i + 1] == '-' || bytes[i + 1] == '+') ? 2 : 1;
            int exponent = 0;
            boolean any = false;
            for (; i < end && bytes[i] >= '0' && bytes[i] <= '9'; i++) {
                exponent = 10 * exponent + (bytes[i] - '0');
                any = true;
            }
            scale += sign * exponent;
            i = any ? i : start;
        }
        if (i != end || count == 0 || digits > 1L << 53 || Math.abs(scale) >= EXACT_POWERS.length) {
            return Double.NaN;
        }
        double value = scale < 0 ? digits / EXACT_POWERS[-scale] : digits * EXACT_POWERS[scale];
        return negative ? -value : value;
    }

    private double slowNumber() {
        for (int i = start; i < end; i++) {
            // Java also reads 1.5f, 1.5d, 0x1p3, NaN and Infinity, which no mesh format means as numbers.
            if ("0123456789+-.eE".indexOf(bytes[i]) < 0) {
                return Double.NaN;
            }
        }
        try {
            return Double.parseDouble(word());
        } catch (NumberFormatException notANumber) {
            return Double.NaN;
        }
    }

    MeshFault fault(String message) {
        return MeshFault.atLine(line, message);
    }
}
