package org.diacaustic.stability;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * Named values of a case. Whatever is asked for and is not there, or is something else, is a {@link CaseFault} that says
 * what was looked for and what was found.
 */
public final class Values {
    private static final Map<String, Double> WORDS = Map.of(
            "inf", Double.POSITIVE_INFINITY,
            "+inf", Double.POSITIVE_INFINITY,
            "infinite", Double.POSITIVE_INFINITY,
            "-inf", Double.NEGATIVE_INFINITY,
            "nan", Double.NaN);

    private final String name;
    private final Map<String, Object> values;

    private Values(String name, Map<?, ?> values) {
        this.name = name;
        this.values = new LinkedHashMap<>();
        values.forEach((key, value) -> this.values.put(String.valueOf(key), value));
    }

    /** @param name what faults call them, such as {@code inputs} */
    public static Values of(String name, Map<?, ?> values) {
        return new Values(name, values);
    }

    public boolean has(String key) {
        return values.containsKey(key);
    }

    public Set<String> keys() {
        return Collections.unmodifiableSet(values.keySet());
    }

    /** A number; a text may be a decimal, a fraction such as 2/3, inf or nan. */
    public double number(String key) {
        return number(key, value(key));
    }

    public double number(String key, double otherwise) {
        return has(key) ? number(key) : otherwise;
    }

    public long integer(String key) {
        double number = number(key);
        if (number != Math.rint(number) || Math.abs(number) > 1e15) {
            throw fault(key, "a whole number", values.get(key));
        }
        return (long) number;
    }

    /** A finite decimal with all digits that are written. */
    public BigDecimal decimal(String key) {
        return decimal(key, value(key));
    }

    /** Whether it is a single finite number. */
    public boolean isDecimal(String key) {
        return has(key) && decimalOrNull(values.get(key)) != null;
    }

    public boolean flag(String key) {
        if (value(key) instanceof Boolean flag) {
            return flag;
        }
        throw fault(key, "true or false", values.get(key));
    }

    public boolean flag(String key, boolean otherwise) {
        return has(key) ? flag(key) : otherwise;
    }

    public String text(String key) {
        return String.valueOf(value(key));
    }

    public String text(String key, String otherwise) {
        return has(key) ? text(key) : otherwise;
    }

    public double[] numbers(String key) {
        return list(key).stream().mapToDouble(value -> number(key, value)).toArray();
    }

    /** Three numbers. */
    public double[] vector(String key) {
        double[] vector = numbers(key);
        if (vector.length != 3) {
            throw fault(key, "three numbers", values.get(key));
        }
        return vector;
    }

    public List<BigDecimal> decimals(String key) {
        return list(key).stream().map(value -> decimal(key, value)).toList();
    }

    /** Lists of numbers. */
    public double[][] rows(String key) {
        List<double[]> rows = new ArrayList<>();
        for (Object row : list(key)) {
            if (!(row instanceof List<?> cells)) {
                throw fault(key, "lists of numbers", row);
            }
            rows.add(cells.stream().mapToDouble(cell -> number(key, cell)).toArray());
        }
        return rows.toArray(new double[0][]);
    }

    /** Lists of named values. */
    public List<Values> records(String key) {
        List<Values> records = new ArrayList<>();
        for (Object record : list(key)) {
            if (!(record instanceof Map<?, ?> members)) {
                throw fault(key, "lists of named values", record);
            }
            records.add(new Values(name + "." + key, members));
        }
        return records;
    }

    public List<String> texts(String key) {
        return list(key).stream().map(String::valueOf).toList();
    }

    /** Any list, as it was read: of numbers, texts, flags and lists. */
    public List<?> list(String key) {
        if (value(key) instanceof List<?> list) {
            return list;
        }
        throw fault(key, "a list", values.get(key));
    }

    private Object value(String key) {
        if (!has(key)) {
            throw new CaseFault("the case does not give " + name + "." + key);
        }
        return values.get(key);
    }

    private double number(String key, Object value) {
        if (value instanceof Number number) {
            return number.doubleValue();
        }
        String text = String.valueOf(value).strip();
        Double word = WORDS.get(text.toLowerCase(Locale.ROOT));
        if (word != null) {
            return word;
        }
        int slash = text.indexOf('/');
        try {
            return slash < 0
                    ? Double.parseDouble(text)
                    : Double.parseDouble(text.substring(0, slash)) / Double.parseDouble(text.substring(slash + 1));
        } catch (NumberFormatException notOne) {
            throw fault(key, "a number", value);
        }
    }

    private BigDecimal decimal(String key, Object value) {
        BigDecimal decimal = decimalOrNull(value);
        if (decimal == null) {
            throw fault(key, "a finite number", value);
        }
        return decimal;
    }

    /** The decimal that a value is, to its last digit; null if it is none. */
    static BigDecimal decimalOrNull(Object value) {
        if (value instanceof Double || value instanceof Float) {
            double number = ((Number) value).doubleValue();
            return Double.isFinite(number) ? new BigDecimal(number) : null;
        }
        try {
            return new BigDecimal(String.valueOf(value).strip());
        } catch (NumberFormatException notOne) {
            return null;
        }
    }

    private CaseFault fault(String key, String wanted, Object found) {
        return new CaseFault(name + "." + key + " should be " + wanted + ", but is " + found);
    }

    @Override
    public String toString() {
        return values.toString();
    }
}
