package org.diacaustic.cli;

import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** A time as it is written on the command line: 10s, 1.5m, 2h, 500ms. */
record TimeSpan(double seconds) {
    private static final Pattern FORM = Pattern.compile("([0-9]{1,9}(?:\\.[0-9]{1,9})?) ?(ms|s|m|h)");
    private static final Map<String, Double> UNITS = Map.of("ms", 1e-3, "s", 1.0, "m", 60.0, "h", 3600.0);

    /** Reads a time. */
    static final class Converter implements ITypeConverter<TimeSpan> {
        @Override
        public TimeSpan convert(String text) {
            Matcher matcher = FORM.matcher(text);
            double seconds = matcher.matches() ? Double.parseDouble(matcher.group(1)) * UNITS.get(matcher.group(2)) : 0;
            if (seconds == 0) {
                throw new TypeConversionException(
                        "expected a number above 0 with a unit ms, s, m or h, such as 10s, found '" + text + "'");
            }
            return new TimeSpan(seconds);
        }
    }
}
