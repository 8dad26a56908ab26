package org.diacaustic.stability;

import java.util.Locale;

/**
 * One thing that a case asks for, and what was found.
 *
 * @param what is compared
 * @param error how far off it is, 0 if it is as expected
 * @param tolerance how far it may be
 * @param slack how much farther without that a picture changes; 0 for what is right or wrong
 */
public record Check(String what, String expected, String got, double error, Tolerance tolerance, double slack) {

    public Verdict verdict() {
        if (error <= tolerance.stretch()) {
            return Verdict.STRETCH;
        }
        if (error <= tolerance.pass()) {
            return Verdict.PASS;
        }
        return error <= tolerance.pass() + slack ? Verdict.RENDER_SAFE : Verdict.FAIL;
    }

    /** Error ÷ tolerance: at most 1 if it passes; endless if no error is tolerated, and there is one. */
    public double ratio() {
        return error == 0 ? 0 : error / tolerance.pass();
    }

    /** Whether the case names a tolerance that only careful arithmetic meets. */
    boolean isStretched() {
        return !Double.isNaN(tolerance.stretch());
    }

    @Override
    public String toString() {
        return String.format(Locale.ROOT, "%s: expected %s, got %s", what, expected, got);
    }
}
