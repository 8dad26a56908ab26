package org.diacaustic.stability;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What became of all cases. */
public final class StabilityReport {
    private final List<CaseResult> results;
    private final Operations operations;
    private final double seconds;

    StabilityReport(List<CaseResult> results, Operations operations, double seconds) {
        this.results = List.copyOf(results);
        this.operations = operations;
        this.seconds = seconds;
    }

    /** In the order of the cases; fewer than those if the run was stopped. */
    public List<CaseResult> results() {
        return results;
    }

    /** Wall time. */
    public double seconds() {
        return seconds;
    }

    Operations operations() {
        return operations;
    }

    public int count(Verdict verdict) {
        return (int)
                results.stream().filter(result -> result.verdict() == verdict).count();
    }

    /** Facts, verdicts and every comparison, for programs. */
    public String json() {
        return StabilityJson.of(this);
    }

    /** The same for people, as Markdown. */
    public String page() {
        return StabilityPage.of(this);
    }

    /** In the order in which cases name them first. */
    public List<CategorySummary> categories() {
        Map<String, List<CaseResult>> byCategory = new LinkedHashMap<>();
        results.forEach(result -> byCategory
                .computeIfAbsent(result.asked().category(), key -> new ArrayList<>())
                .add(result));
        return byCategory.entrySet().stream()
                .map(entry -> CategorySummary.of(entry.getKey(), entry.getValue()))
                .toList();
    }
}
