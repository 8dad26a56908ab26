package org.diacaustic.cli;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** A size as it is written on the command line: 640x480. */
record PixelSize(int width, int height) {
    private static final Pattern FORM = Pattern.compile("([1-9][0-9]{0,9})[xX]([1-9][0-9]{0,9})");

    /** Reads a size. */
    static final class Converter implements ITypeConverter<PixelSize> {
        @Override
        public PixelSize convert(String text) {
            Matcher matcher = FORM.matcher(text);
            if (!matcher.matches()) {
                throw new TypeConversionException(
                        "expected two whole numbers of at least 1, such as 640x480, found '" + text + "'");
            }
            return new PixelSize(side(matcher.group(1)), side(matcher.group(2)));
        }

        private static int side(String text) {
            long side = Long.parseLong(text);
            if (side > Integer.MAX_VALUE) {
                throw new TypeConversionException("a side has at most " + Integer.MAX_VALUE + " pixels, not " + text);
            }
            return (int) side;
        }
    }
}
