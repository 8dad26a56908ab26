package org.diacaustic.study;

import java.util.List;
import org.apache.commons.math3.stat.regression.SimpleRegression;

/**
 * What a technique did, from few light rays to many.
 *
 * @param runs in the order of their rays; none if the technique was refused
 * @param refusal why it cannot render the scene; empty if it can
 */
public record TechniqueStudy(Technique technique, List<StudyRun> runs, String refusal) {

    public TechniqueStudy {
        runs = List.copyOf(runs);
    }

    /** The slope of log error by log light rays, of root mean squares, as far as the reference resolves them. */
    public Slope slope() {
        SimpleRegression regression = new SimpleRegression();
        for (StudyRun run : runs) {
            if (run.error().isResolved() && run.lightRays() > 0) {
                regression.addData(
                        Math.log(run.lightRays()), Math.log(run.error().rms()));
            }
        }
        return new Slope(regression.getSlope(), regression.getSlopeStdErr(), regression.getN());
    }

    /**
     * A slope that was fitted.
     *
     * @param value not a number if there are fewer than two points
     * @param standardError of a straight line; not a number if there are fewer than three points
     * @param points that it was fitted to
     */
    public record Slope(double value, double standardError, long points) {}
}
