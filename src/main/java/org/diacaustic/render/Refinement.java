package org.diacaustic.render;

import java.util.concurrent.atomic.AtomicBoolean;

/**
 * Renders until a goal is reached. A caustic mesh is made anew with more light rays, round after round, until its estimated error
 * is small enough or the time is used; with other maps passes are averaged until their noise is. A scene that needs no map has
 * no error of one, and is rendered once. Runs once; may be cancelled from anywhere.
 *
 * <p>Only how many rounds there are depends on time. The picture has the bits of a render of {@link Refined#plan()}.
 */
public final class Refinement {
    private final Rounds rounds;
    private final RoundSignal signal;
    private final AtomicBoolean started = new AtomicBoolean();

    /**
     * @param plan of the first round, or of one pass
     * @param threads at least 1
     * @param listener hears how far it is: with a deadline, how much of the time is over; else how far each round of a mesh is,
     *     or what part of the passes is done
     * @throws ResourceLimitException if the picture does not fit in memory
     */
    public Refinement(RenderPlan plan, Goal goal, int threads, ProgressListener listener) {
        PassRun.requireThreads(threads);
        boolean hasMesh = plan.estimatesError();
        plan.requireMemory(!hasMesh || plan.passes() > 1);
        plan.requireCountable(plan.passes());
        this.signal = new RoundSignal(goal);
        this.rounds = hasMesh
                ? new MeshRounds(plan, goal, threads, signal, listener)
                : new PassRounds(plan, goal, threads, signal, listener);
    }

    /** Ends it soon, from any thread; {@link #run()} then returns what there is. */
    public void cancel() {
        signal.cancel();
    }

    /**
     * Renders, and returns when every thread has ended. An interrupt of the calling thread cancels it and stays set.
     *
     * @throws ResourceLimitException if the first round needs more than there is
     * @throws IllegalStateException if it has run already
     */
    public Refined run() {
        if (started.getAndSet(true)) {
            throw new IllegalStateException("a refinement runs once");
        }
        try (signal) {
            signal.open();
            return rounds.run();
        }
    }
}
