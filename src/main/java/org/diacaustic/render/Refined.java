package org.diacaustic.render;

import java.util.List;
import java.util.Optional;

/**
 * What a {@link Refinement} made.
 *
 * @param rendering of the last round that came to its end; not complete only if the first did not
 * @param plan of it: rendered alone, it gives the same bits
 * @param rounds all, in their order; the last may have been stopped
 * @param end why there were no more
 * @param shortfall what was asked, what was reached and why it ended, in a sentence; nothing if all that was asked is there
 */
public record Refined(Rendering rendering, RenderPlan plan, List<Round> rounds, End end, Optional<String> shortfall) {

    /** Why there is no further round. */
    public enum End {
        /** Nothing more was asked. */
        DONE,
        /** The next would not be ready in time. */
        TIME,
        /** The next has no room in memory. */
        MEMORY,
        /** There are as many light rays, or passes, as a render can have. */
        COUNT,
        /** Two brought the picture no further. */
        NO_PROGRESS,
        /** Somebody cancelled it. */
        CANCELLED
    }

    /** The estimate that the goal is about: the error of the map, or else the noise; not a number if there is no telling. */
    public double estimate() {
        return estimate(rendering);
    }

    static double estimate(Rendering rendering) {
        double error = rendering.errorEstimate();
        return Double.isNaN(error) ? rendering.noiseEstimate() : error;
    }
}
