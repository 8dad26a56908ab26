package org.diacaustic.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/** Points of a study that nothing was rendered for. */
final class StudyPoints {
    static final Technique TECHNIQUE = new Technique("any", Technique.Way.OVER_A_MAP, Map.of(), 0);

    private StudyPoints() {}

    /** One run each: 1000, 10,000, ... light rays, as many milliseconds. */
    static TechniqueStudy study(double referenceError, double... errors) {
        List<StudyPoint> points = new ArrayList<>();
        for (int i = 0; i < errors.length; i++) {
            points.add(point((long) Math.pow(10, 3 + i), Double.NaN, Double.NaN, referenceError, errors[i]));
        }
        return new TechniqueStudy(TECHNIQUE, points, "");
    }

    /** A run for each error. */
    static StudyPoint point(long rays, double squaredBias, double variance, double referenceError, double... errors) {
        List<StudyRun> runs = IntStream.range(0, errors.length)
                .mapToObj(i -> new StudyRun(
                        i,
                        Map.of(
                                Measure.RMS_ERROR, errors[i],
                                Measure.LIGHT_RAYS, 3.0 * rays,
                                Measure.PROCESSOR_SECONDS, 1e-3 * rays)))
                .toList();
        return new StudyPoint(new Budget.Rays(rays), rays, 1, squaredBias, variance, referenceError, runs);
    }
}
