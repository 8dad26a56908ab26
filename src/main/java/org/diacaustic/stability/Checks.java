package org.diacaustic.stability;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Compares what an operation finds with what its case expects. */
public final class Checks {
    private static final double RENDER_SAFE = 1e-9;

    private final NumericCase asked;
    private final List<Check> checks = new ArrayList<>();
    private final List<String> notes = new ArrayList<>();
    private String inapplicable = "";
    private double size;

    public Checks(NumericCase asked) {
        this.asked = asked;
    }

    /** Says how large the object is that the case is about, in the unit of its numbers: 1e-9 of it changes no picture. */
    public Checks size(double objectSize) {
        size = objectSize;
        return this;
    }

    /** A number of the case's answer, within the tolerance that the case has for that name. */
    public Checks number(String name, double got) {
        return number(name, got, name);
    }

    /** The same under another name of the tolerance: {@code T} for {@code T_abs_each}. */
    public Checks number(String name, double got, String stem) {
        if (!asked.expected().isDecimal(name)) {
            return special(name, asked.expected().number(name), got);
        }
        return number(name, asked.expected().decimal(name), got, stem);
    }

    /** Numbers of a list of the case's answer, each within the tolerance of that name. */
    public Checks numbers(String name, double[] got, String stem) {
        List<BigDecimal> expected = asked.expected().decimals(name);
        if (expected.size() != got.length) {
            return same("length of " + name, expected.size(), got.length);
        }
        for (int i = 0; i < got.length; i++) {
            number(name + "[" + i + "]", expected.get(i), got[i], stem);
        }
        return this;
    }

    /** A number that the answer has under no name of its own. */
    public Checks number(String what, BigDecimal expected, double got, String stem) {
        return number(what, expected, got, Tolerance.of(asked.tolerance(), stem, expected));
    }

    /** A number within a tolerance that the operation knows. */
    public Checks number(String what, double expected, double got, double tolerance) {
        if (!Double.isFinite(expected)) {
            return special(what, expected, got);
        }
        return number(what, new BigDecimal(expected), got, Tolerance.of(tolerance));
    }

    private Checks number(String what, BigDecimal expected, double got, Tolerance tolerance) {
        double error = Double.isFinite(got)
                ? expected.subtract(new BigDecimal(got)).abs().doubleValue()
                : Double.POSITIVE_INFINITY;
        double slack = RENDER_SAFE * Math.max(expected.abs().doubleValue(), size);
        checks.add(new Check(
                what, expected.round(new MathContext(12)).toString(), Double.toString(got), error, tolerance, slack));
        return this;
    }

    /** What is not a finite number is that or it is not. */
    private Checks special(String what, double expected, double got) {
        return same(what, expected, got);
    }

    /** A mean or a frequency, within so many standard errors of its expectation. */
    public Checks statistic(String what, double expected, double got, double standardError, double sigmas) {
        double tolerance = sigmas * standardError;
        double error = Double.isNaN(got) ? Double.POSITIVE_INFINITY : Math.abs(got - expected);
        checks.add(new Check(
                what + " (within " + trimmed(sigmas) + " sigma)",
                Double.toString(expected),
                Double.toString(got),
                error,
                Tolerance.of(tolerance),
                0));
        return this;
    }

    /** A number that must not be larger than a limit; how much of the limit it takes is its error ÷ tolerance. */
    public Checks atMost(String what, double limit, double got) {
        double error = Double.isNaN(got) ? Double.POSITIVE_INFINITY : Math.max(0, got);
        checks.add(new Check(what, "at most " + trimmed(limit), Double.toString(got), error, Tolerance.of(limit), 0));
        return this;
    }

    /** What must be just so. */
    public Checks same(String what, Object expected, Object got) {
        return rule(what, String.valueOf(expected), String.valueOf(got), expected.equals(got));
    }

    /** What is right or wrong. */
    public Checks rule(String what, String expected, String got, boolean met) {
        checks.add(new Check(what, expected, got, met ? 0 : Double.POSITIVE_INFINITY, Tolerance.of(0), 0));
        return this;
    }

    /** What must hold. */
    public Checks holds(String what, boolean met) {
        return rule(what, "true", Boolean.toString(met), met);
    }

    /** Says what else is to be known of the result, such as which of several acceptable answers it is. */
    public Checks note(String note) {
        notes.add(note);
        return this;
    }

    /** Says that the case cannot apply, and why: nothing that was compared counts, but what has failed. */
    public void notApplicable(String reason) {
        inapplicable = reason;
    }

    CaseResult result(double seconds) {
        boolean hasFailed = checks.stream().anyMatch(check -> check.verdict() == Verdict.FAIL);
        if (!inapplicable.isEmpty() && !hasFailed) {
            return CaseResult.notApplicable(asked, inapplicable);
        }
        if (checks.isEmpty()) {
            throw new IllegalStateException("the operation " + asked.operation() + " compared nothing");
        }
        return new CaseResult(asked, checks, notes, "", seconds);
    }

    private static String trimmed(double number) {
        return number == Math.rint(number) && Math.abs(number) < 1e9
                ? Long.toString((long) number)
                : String.format(Locale.ROOT, "%.4g", number);
    }
}
