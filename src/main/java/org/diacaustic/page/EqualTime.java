package org.diacaustic.page;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.diacaustic.study.Measure;
import org.diacaustic.study.StudyPoint;
import org.diacaustic.study.StudyReport;
import org.diacaustic.study.TechniqueStudy;
import org.diacaustic.study.TimeToError;

/**
 * Who is best with the same processor time: at a short time, by which half of the techniques have a picture, and at the longest
 * that half of them reach. Nothing is told of times outside of a technique's points.
 */
final class EqualTime {
    private static final Measure TIME = Measure.PROCESSOR_SECONDS;

    /** Errors and times that differ by less are called alike. */
    private static final double ALIKE = 1.1;

    private final StudyNumbers numbers;
    private final List<TechniqueStudy> timed;

    /** Error that the reference can tell. */
    private final double least;

    private EqualTime(StudyReport report) {
        this.numbers = new StudyNumbers(report);
        this.timed = numbers.started().stream()
                .filter(study -> start(study) > 0 && end(study) > 0)
                .toList();
        this.least = StudyPoint.REFERENCE_MARGIN
                * timed.stream()
                        .mapToDouble(study -> StudyNumbers.last(study).referenceError())
                        .max()
                        .orElse(0);
    }

    static List<Finding> of(StudyReport report) {
        EqualTime equal = new EqualTime(report);
        return equal.timed.size() < 2 ? List.of() : equal.findings();
    }

    private List<Finding> findings() {
        double early = timed.stream()
                .map(EqualTime::start)
                .sorted()
                .skip((timed.size() - 1) / 2)
                .findFirst()
                .orElseThrow();
        double late = timed.stream()
                .map(EqualTime::end)
                .sorted(Comparator.reverseOrder())
                .skip((timed.size() - 1) / 2)
                .findFirst()
                .orElseThrow();
        List<Finding> findings = new ArrayList<>();
        if (ALIKE * early < late) {
            winner(early).ifPresent(findings::add);
        }
        winner(late).ifPresent(findings::add);
        List<TechniqueStudy> ranked = ranked(late);
        if (ranked.size() > 1) {
            faster(ranked).ifPresent(findings::add);
        }
        return findings;
    }

    /**
     * The techniques that have points before and after the time, least error first. Those with less than the reference can tell are
     * in the order in which they came so far.
     */
    private List<TechniqueStudy> ranked(double time) {
        return timed.stream()
                .filter(study -> start(study) <= time && end(study) >= time)
                .sorted(Comparator.<TechniqueStudy>comparingDouble(study -> error(study, time))
                        .thenComparingDouble(study -> least > 0 ? seconds(TimeToError.of(study, least, TIME)) : 0))
                .toList();
    }

    /** No less than the reference can tell. */
    private double error(TechniqueStudy study, double time) {
        return Math.max(least, numbers.errorAt(study, TIME, time));
    }

    private Optional<Finding> winner(double time) {
        List<TechniqueStudy> ranked = ranked(time);
        if (ranked.size() < 2) {
            return Optional.empty();
        }
        TechniqueStudy best = ranked.get(0);
        TechniqueStudy next = ranked.get(1);
        double bestError = error(best, time);
        double nextError = error(next, time);
        String start = "With " + Numbers.seconds(time) + " of processors, ";
        long untold = ranked.stream()
                .filter(study -> numbers.errorAt(study, TIME, time) < least)
                .count();
        if (untold > 1) {
            return winner(start + untold + " techniques have less error than " + Numbers.percent(least)
                    + ", which is all that the reference tells; " + name(best) + " came so far first.");
        }
        String found = start + name(best) + " has the least error, " + (untold == 1 ? "less than " : "")
                + Numbers.percent(bestError);
        return winner(
                nextError < ALIKE * bestError
                        ? found + "; " + name(next) + " has about as little."
                        : found + ". Next is " + name(next) + " with " + Numbers.percent(nextError) + ".");
    }

    private static Optional<Finding> winner(String text) {
        return Optional.of(new Finding(Finding.Kind.WINNER, text));
    }

    /** The best against the next one and against the best of each other family, first those that have points around the time. */
    private Optional<Finding> faster(List<TechniqueStudy> ranked) {
        TechniqueStudy best = ranked.get(0);
        Map<String, TechniqueStudy> rivals = new LinkedHashMap<>();
        rivals.put(family(ranked.get(1)), ranked.get(1));
        Stream.concat(ranked.stream(), timed.stream().sorted(Comparator.comparingDouble(EqualTime::shown)))
                .filter(study -> !family(study).equals(family(best)))
                .forEach(study -> rivals.putIfAbsent(family(study), study));
        List<String> words = new ArrayList<>();
        rivals.values().forEach(rival -> against(best, rival).ifPresent(words::add));
        return words.isEmpty()
                ? Optional.empty()
                : Optional.of(new Finding(
                        Finding.Kind.FASTER,
                        "To an error that both reach, " + name(best) + " takes " + String.join("; ", words) + "."));
    }

    private Optional<String> against(TechniqueStudy best, TechniqueStudy rival) {
        double reached = Math.max(least, Math.max(shown(best), shown(rival)));
        TimeToError bestTime = TimeToError.of(best, reached, TIME);
        TimeToError rivalTime = TimeToError.of(rival, reached, TIME);
        boolean bestIsBound = bestTime instanceof TimeToError.AtMost;
        boolean rivalIsBound = rivalTime instanceof TimeToError.AtMost;
        double times = seconds(rivalTime) / seconds(bestTime);
        if (Double.isNaN(times) || bestIsBound && rivalIsBound) {
            return Optional.empty();
        }
        String rest = " than " + name(rival) + " (to " + Numbers.percent(reached) + ")";
        if (times < ALIKE && times > 1 / ALIKE) {
            return Optional.of("about as long as " + name(rival) + " (to " + Numbers.percent(reached) + ")");
        }
        boolean isLess = times > 1;
        // The best in less than its first point, or the rival in less than its own: one side is known only.
        String bound = bestIsBound == rivalIsBound ? "" : bestIsBound == isLess ? "at least " : "at most ";
        return Optional.of(bound + Numbers.digits(isLess ? times : 1 / times) + " times "
                + (isLess ? "less time" : "longer") + rest);
    }

    private static double seconds(TimeToError time) {
        if (time instanceof TimeToError.Reached reached) {
            return reached.cost();
        }
        return time instanceof TimeToError.AtMost atMost ? atMost.cost() : Double.NaN;
    }

    private static double shown(TechniqueStudy study) {
        return StudyNumbers.last(study).shownError();
    }

    private static double start(TechniqueStudy study) {
        return study.points().get(0).mean(TIME);
    }

    private static double end(TechniqueStudy study) {
        return StudyNumbers.last(study).mean(TIME);
    }

    private static String name(TechniqueStudy study) {
        return study.technique().name();
    }

    private static String family(TechniqueStudy study) {
        return study.technique().family();
    }
}
