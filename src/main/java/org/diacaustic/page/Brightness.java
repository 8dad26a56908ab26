package org.diacaustic.page;

import java.util.List;
import org.diacaustic.study.Distribution;
import org.diacaustic.study.Interval;
import org.diacaustic.study.Measure;
import org.diacaustic.study.TechniqueStudy;

/**
 * How much too bright or too dark a technique is with its largest budget, on the mean over all pixels that count. {@link
 * Findings} tells whether more rays would help.
 *
 * @param difference mean signed difference ÷ mean of the light that comes over specular surfaces
 * @param interval where the true one lies; unknown of one run
 */
record Brightness(String name, double difference, Interval interval) {
    /** What is farther from 0 than this, with certainty, is wrong. */
    static final double TOLERANCE = 0.01;

    /** Of all techniques that have points. */
    static List<Brightness> all(StudyNumbers numbers) {
        return numbers.started().stream().map(study -> of(study, numbers)).toList();
    }

    private static Brightness of(TechniqueStudy study, StudyNumbers numbers) {
        Distribution last = numbers.distribution(StudyNumbers.last(study), Measure.BRIGHTNESS);
        return new Brightness(study.technique().name(), last.mean(), last.meanInterval());
    }

    /** Whether it is certainly off by more than the tolerance; nothing is certain of one run. */
    boolean isWrong() {
        return interval.low() > TOLERANCE || interval.high() < -TOLERANCE;
    }

    /** All that is known. */
    String words() {
        return name + ": " + Numbers.signedPercent(difference) + ", the true mean "
                + Numbers.interval(interval, Numbers::signedPercent);
    }
}
