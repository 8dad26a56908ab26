package org.diacaustic.page;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.diacaustic.study.Distribution;
import org.diacaustic.study.Interval;
import org.diacaustic.study.Measure;
import org.diacaustic.study.TechniqueStudy;

/**
 * Techniques whose mean brightness is off by more than 1 % at their two largest budgets, as far as their intervals tell. Those
 * that are off in the same way are told in one sentence.
 */
final class WrongBrightness {
    /** How far a mean brightness may be off and still be called right. */
    private static final double RIGHT = 0.01;

    /** A brightness error that shrinks to this part with the largest budget is on its way. */
    private static final double SHRINKS = 0.7;

    /** Who is off, and by how much, by how that is told. */
    private final Map<String, List<String>> wrong = new LinkedHashMap<>();

    private final List<Finding> findings = new ArrayList<>();

    private WrongBrightness() {}

    static List<Finding> of(List<TechniqueStudy> started) {
        WrongBrightness brightness = new WrongBrightness();
        started.forEach(brightness::add);
        brightness.wrong.forEach(
                (how, names) -> brightness.findings.add(new Finding(Finding.Kind.WRONG, joined(names) + how)));
        return brightness.findings;
    }

    private void add(TechniqueStudy study) {
        List<Distribution> known = study.points().stream()
                .map(point -> point.distribution(Measure.BRIGHTNESS))
                .filter(brightness -> !Double.isNaN(brightness.meanInterval().low()))
                .toList();
        int count = known.size();
        if (count == 0) {
            return;
        }
        Distribution last = known.get(count - 1);
        Distribution before = known.get(Math.max(0, count - 2));
        int side = side(last.meanInterval());
        if (side == 0 || side(before.meanInterval()) != side) {
            return;
        }
        String name = study.technique().name();
        String amount = Numbers.percent(Math.abs(last.mean()));
        String too = side > 0 ? " too bright" : " too dark";
        if (Math.abs(last.mean()) < SHRINKS * Math.abs(before.mean())) {
            findings.add(new Finding(
                    Finding.Kind.NOTE,
                    name + " is still " + amount + too + " at its largest budget, but was off by "
                            + Numbers.percent(Math.abs(before.mean())) + " at the one before."));
            return;
        }
        boolean always = known.stream().allMatch(each -> side(each.meanInterval()) == side);
        String where = count == 1
                ? " at the one budget that tells."
                : always
                        ? " at every budget: more rays do not help."
                        : " at the two largest budgets: more rays do not help.";
        List<String> names = wrong.computeIfAbsent(too + where, how -> new ArrayList<>());
        names.add(name + (names.isEmpty() ? " is " : " ") + amount);
    }

    /** 1 if surely too bright, −1 if surely too dark. */
    private static int side(Interval interval) {
        return interval.low() > RIGHT ? 1 : interval.high() < -RIGHT ? -1 : 0;
    }

    /** A, B and C. */
    private static String joined(List<String> names) {
        int last = names.size() - 1;
        return last == 0 ? names.get(0) : String.join(", ", names.subList(0, last)) + " and " + names.get(last);
    }
}
