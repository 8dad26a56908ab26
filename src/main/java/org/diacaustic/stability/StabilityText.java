package org.diacaustic.stability;

import java.util.Locale;

/** Results as lines of text. */
public final class StabilityText {
    private StabilityText() {}

    /** One line: id, what the case is, what was expected and found, error ÷ tolerance, verdict. */
    public static String line(CaseResult result) {
        String start = result.asked().id() + "  " + result.asked().title() + "  ";
        if (!result.reason().isEmpty()) {
            return start + result.verdict() + ": " + result.reason();
        }
        return start + oneLine(result.worst().toString()) + "  " + ratio(result.ratio()) + "  " + result.verdict();
    }

    /** One line a category: how many cases have which verdict, and the median and the worst error ÷ tolerance. */
    public static String line(CategorySummary category) {
        StringBuilder line = new StringBuilder(64);
        line.append(String.format(Locale.ROOT, "%-8s %3d", category.category(), category.cases()));
        for (Verdict verdict : Verdict.values()) {
            if (category.count(verdict) > 0) {
                line.append("  ").append(category.count(verdict)).append(' ').append(verdict);
            }
        }
        category.worst()
                .ifPresent(worst -> line.append("  error/tolerance: median ")
                        .append(ratio(category.medianRatio()))
                        .append(", worst ")
                        .append(ratio(worst.ratio()))
                        .append(" at ")
                        .append(worst.asked().id()));
        return line.toString();
    }

    /** One line: all verdicts and the time. */
    public static String summary(StabilityReport report) {
        StringBuilder line = new StringBuilder(64);
        line.append(report.results().size()).append(" cases");
        for (Verdict verdict : Verdict.values()) {
            if (report.count(verdict) > 0) {
                line.append(", ").append(report.count(verdict)).append(' ').append(verdict);
            }
        }
        return line.append(String.format(Locale.ROOT, "; %.1f s", report.seconds()))
                .toString();
    }

    /** Three digits, and no more than needed. */
    static String ratio(double ratio) {
        if (Double.isInfinite(ratio)) {
            return "inf";
        }
        if (ratio == 0) {
            return "0";
        }
        return String.format(Locale.ROOT, ratio >= 0.001 && ratio < 1000 ? "%.3g" : "%.1e", ratio);
    }

    static String oneLine(String text) {
        return text.strip().replaceAll("\\s*\\R\\s*", "; ");
    }
}
