package org.diacaustic.render;

import java.util.concurrent.TimeUnit;
import org.diacaustic.parallel.StopSignal;

/** Stops the rounds of a refinement: each has a signal of its own, and all are set by a cancel or at the deadline. */
final class RoundSignal implements AutoCloseable {
    private final Goal goal;
    private final Thread watch;
    private volatile StopSignal current = new StopSignal();
    private volatile boolean isCancelled;
    private volatile boolean isOverdue;

    RoundSignal(Goal goal) {
        this.goal = goal;
        this.watch = new Thread(this::awaitDeadline, "diacaustic-deadline");
        watch.setDaemon(true);
    }

    /** Begins to watch the deadline, if there is one; until {@link #close}. */
    void open() {
        if (goal.deadline().isPresent()) {
            watch.start();
        }
    }

    private void awaitDeadline() {
        try {
            TimeUnit.NANOSECONDS.sleep((long) (1e9 * goal.secondsLeft()));
            isOverdue = true;
            current.set();
        } catch (InterruptedException notNeeded) {
            Thread.currentThread().interrupt();
        }
    }

    void cancel() {
        isCancelled = true;
        current.set();
    }

    /** The signal of a new round. */
    StopSignal next() {
        current = new StopSignal();
        // Whoever sets these first and then the signal has set this one, or is seen here.
        if (isCancelled || isOverdue) {
            current.set();
        }
        return current;
    }

    /** Why a round was stopped. */
    Refined.End end() {
        return isOverdue && !isCancelled ? Refined.End.TIME : Refined.End.CANCELLED;
    }

    @Override
    public void close() {
        watch.interrupt();
    }
}
