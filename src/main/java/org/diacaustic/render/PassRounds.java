package org.diacaustic.render;

import org.diacaustic.render.Refined.End;

/** More and more passes that are averaged, or the one that there is without a forward pass. Rounds double their number. */
final class PassRounds extends Rounds {
    /** From fewer passes there is no telling how noisy they are. */
    private static final int LEAST_PASSES = 8;

    private static final int MOST_PASSES = 1 << 16;

    /** A pass is begun if it would end in time even if it took so many times as long as the longest yet. */
    private static final double CAREFUL = 1.1;

    private final int most;
    private final FractionProgress part;
    private int done;
    private double needed = LEAST_PASSES;

    PassRounds(RenderPlan plan, Goal goal, int threads, RoundSignal signal, ProgressListener listener) {
        super(plan, goal, threads, signal, listener);
        this.most = plan.forward().isPresent() ? Math.min(MOST_PASSES, Integer.MAX_VALUE / plan.tileCount()) : 1;
        this.part = new FractionProgress(listener);
    }

    @Override
    String counted() {
        return "passes";
    }

    @Override
    String estimated() {
        return "noise";
    }

    @Override
    String stuck() {
        return "all passes are alike";
    }

    @Override
    End renderAll() {
        PassRun run = new PassRun(plan, threads, signal.next(), most > 1);
        double roundSeconds = 0;
        double longest = 0;
        while (true) {
            long start = System.nanoTime();
            End end = renderPass(run);
            double seconds = (System.nanoTime() - start) * 1e-9;
            longest = Math.max(longest, seconds);
            roundSeconds += seconds;
            if (end == null && CAREFUL * longest > goal.secondsLeft()) {
                end = End.TIME;
            }
            if (end != null || Integer.bitCount(done) == 1) {
                note(new Round(plan.lightRays(), done, roundSeconds, Refined.estimate(picture())));
                roundSeconds = 0;
            }
            if (end != null) {
                return end;
            }
        }
    }

    /** Null if nothing but time is against a further pass. */
    private End renderPass(PassRun run) {
        Rendering rendering;
        try {
            run.render(new RenderProgress(plan, 1, plan.forward().isPresent(), passListener()));
            rendering = run.renderingSoFar(done + 1);
        } catch (ResourceLimitException | OutOfMemoryError tooMuch) {
            if (picture() == null) {
                throw tooMuch;
            }
            return End.MEMORY;
        }
        keep(rendering, plan.settings().forward().rays(), done + 1);
        if (!rendering.isComplete()) {
            return signal.end();
        }
        done++;
        return endAfter(rendering.noiseEstimate());
    }

    private End endAfter(double noise) {
        if (plan.forward().isEmpty() || done >= LEAST_PASSES && goal.isReachedBy(noise)) {
            part.at(1);
            return End.DONE;
        }
        if (done >= LEAST_PASSES && Double.isNaN(noise)) {
            return End.NO_PROGRESS;
        }
        if (done == most) {
            return End.COUNT;
        }
        if (goal.error().isPresent() && done > 1) {
            // Noise falls like one over the root of the passes.
            double ratio = noise / goal.error().getAsDouble();
            needed = Math.max(LEAST_PASSES, done * ratio * ratio);
        }
        return null;
    }

    private ProgressListener passListener() {
        return goal.deadline().isPresent()
                ? listener()
                : (parts, total) -> part.at((done + (double) parts / total) / needed);
    }
}
