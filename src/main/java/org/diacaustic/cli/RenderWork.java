package org.diacaustic.cli;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.diacaustic.render.Goal;
import org.diacaustic.render.ProgressListener;
import org.diacaustic.render.Refined;
import org.diacaustic.render.Refinement;
import org.diacaustic.render.RenderJob;
import org.diacaustic.render.RenderPlan;

/**
 * A render that is about to run: of the plan as it is, or until a goal is reached.
 *
 * @param run renders, once
 * @param cancel ends it soon, from any thread
 */
record RenderWork(Supplier<Refined> run, Runnable cancel) {

    static RenderWork of(RenderPlan plan, Optional<Goal> goal, int threads, ProgressListener listener) {
        if (goal.isPresent()) {
            Refinement refinement = new Refinement(plan, goal.get(), threads, listener);
            return new RenderWork(refinement::run, refinement::cancel);
        }
        RenderJob job = new RenderJob(plan, threads, listener);
        return new RenderWork(
                () -> new Refined(job.run(), plan, List.of(), Refined.End.DONE, Optional.empty()), job::cancel);
    }
}
