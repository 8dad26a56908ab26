package org.diacaustic.stability;

import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What became of the cases of a category.
 *
 * @param counts how many cases have each verdict that any has
 * @param medianRatio of error ÷ tolerance, over cases that apply; not a number if none does
 * @param worst the case that is nearest to failing, or has failed the most
 */
public record CategorySummary(
        String category, int cases, Map<Verdict, Integer> counts, double medianRatio, Optional<CaseResult> worst) {

    static CategorySummary of(String category, List<CaseResult> results) {
        Map<Verdict, Integer> counts = new EnumMap<>(Verdict.class);
        results.forEach(result -> counts.merge(result.verdict(), 1, Integer::sum));
        double[] ratios = results.stream()
                .filter(result -> !result.checks().isEmpty())
                .mapToDouble(CaseResult::ratio)
                .sorted()
                .toArray();
        int half = ratios.length / 2;
        double median = ratios.length == 0
                ? Double.NaN
                : ratios.length % 2 == 1 ? ratios[half] : 0.5 * (ratios[half - 1] + ratios[half]);
        Optional<CaseResult> worst = results.stream()
                .filter(result -> !result.checks().isEmpty())
                .max(Comparator.comparing((CaseResult result) -> result.worst().verdict())
                        .thenComparingDouble(CaseResult::ratio));
        return new CategorySummary(category, results.size(), counts, median, worst);
    }

    public int count(Verdict verdict) {
        return counts.getOrDefault(verdict, 0);
    }
}
