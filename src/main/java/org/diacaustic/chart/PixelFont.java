package org.diacaustic.chart;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/**
 * Capital letters, digits and a few signs of 5 × 7 dots, for charts as pictures: they look the same everywhere, and need
 * no fonts of the machine.
 */
final class PixelFont {
    static final int WIDTH = 5;
    static final int HEIGHT = 7;
    /** From one character to the next. */
    static final int ADVANCE = 6;

    /** A character, then its rows from the top, two hexadecimal digits each; the leftmost dot is the bit of value 16. */
    private static final String GLYPHS = """
            A0E11111F111111 B1E11111E11111E C0E11101010110E D1C12111111121C E1F10101E10101F F1F10101E101010
            G0E11101713110F H1111111F111111 I0E04040404040E J0702020202120C K11121418141211 L1010101010101F
            M111B1515111111 N11191513111111 O0E11111111110E P1E11111E101010 Q0E11111115120D R1E11111E141211
            S0F10100E01011E T1F040404040404 U1111111111110E V1111111111 0A04 W1111111515150A X11110A040A1111
            Y11110A04040404 Z1F01020408101F 00E11131519110E 1040C040404040E 20E11010204081F 31F02040201110E
            402060A121F0202 51F101E0101110E 60608101E11110E 71F010204080808 80E11110E11110E 90E11110F01020C
            ,00000000040408 .0000000000060C -0000001F000000 +0004041F040400 %18190204081303 (0204080808 0402
            )0804020202 0408 /00010204081000 :00060600060600 =00001F001F0000
            """;

    private static final Map<Character, int[]> ROWS = parse();

    private PixelFont() {}

    private static Map<Character, int[]> parse() {
        Map<Character, int[]> glyphs = new HashMap<>();
        String packed = GLYPHS.replaceAll("\\s", "");
        int length = 1 + 2 * HEIGHT;
        for (int i = 0; i < packed.length(); i += length) {
            int[] rows = new int[HEIGHT];
            for (int row = 0; row < HEIGHT; row++) {
                int at = i + 1 + 2 * row;
                rows[row] = Integer.parseInt(packed.substring(at, at + 2), 16);
            }
            glyphs.put(packed.charAt(i), rows);
        }
        return glyphs;
    }

    static int width(String text) {
        return text.length() * ADVANCE - (ADVANCE - WIDTH);
    }

    /** Whether a dot is set of a character in a row from the top and a column from the left; what is unknown is blank. */
    static boolean isSet(char character, int row, int column) {
        int[] rows = ROWS.get(String.valueOf(character).toUpperCase(Locale.ROOT).charAt(0));
        return rows != null && (rows[row] >> (WIDTH - 1 - column) & 1) != 0;
    }
}
