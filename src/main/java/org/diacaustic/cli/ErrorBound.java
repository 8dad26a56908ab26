package org.diacaustic.cli;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** An error as it is written on the command line, 1% or 0.01. */
record ErrorBound(double part) {
    private static final Pattern FORM = Pattern.compile("([0-9]{0,9}\\.?[0-9]{1,18}(?:[eE]-[0-9]{1,2})?) ?(%?)");

    /** Reads an error. */
    static final class Converter implements ITypeConverter<ErrorBound> {
        @Override
        public ErrorBound convert(String text) {
            Matcher matcher = FORM.matcher(text);
            double part = matcher.matches()
                    ? Double.parseDouble(matcher.group(1)) / (matcher.group(2).isEmpty() ? 1 : 100)
                    : 0;
            if (!(part > 0 && part <= 1)) {
                throw new TypeConversionException(
                        "expected an error above 0 and up to 100%, such as 1% or 0.01, found '" + text + "'");
            }
            return new ErrorBound(part);
        }
    }
}
