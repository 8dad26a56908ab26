package org.diacaustic.parallel;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;

/**
 * Runs numbered tasks on a number of threads. Which thread runs which task is chance: a task's result may depend on its
 * number only, and what tasks share is written to places of their own.
 */
public final class Workers {
    private final int threads;
    private final StopSignal stop;

    /**
     * @param threads at least 1
     * @param stop no task begins after it is set; tasks that take long look at it themselves
     */
    public Workers(int threads, StopSignal stop) {
        if (threads < 1) {
            throw new IllegalArgumentException("work needs at least 1 thread, but has " + threads);
        }
        this.threads = threads;
        this.stop = stop;
    }

    /** Workers that nobody stops. */
    public Workers(int threads) {
        this(threads, new StopSignal());
    }

    public int threads() {
        return threads;
    }

    public StopSignal stop() {
        return stop;
    }

    /**
     * Runs the tasks 0 to {@code count} − 1 and returns when every thread has ended. An interrupt of the
     * calling thread sets the stop signal and stays set.
     *
     * @param makeTask called once by each thread: what a thread uses again from task to task belongs to what it returns
     * @throws RuntimeException or {@link Error}: the first that a task has thrown; the stop signal is set then
     */
    public void run(int count, Supplier<? extends Task> makeTask) {
        AtomicInteger next = new AtomicInteger();
        AtomicReference<Throwable> failure = new AtomicReference<>();
        List<Thread> started = new ArrayList<>();
        for (int i = 0; i < Math.min(threads, count); i++) {
            Thread thread = new Thread(() -> work(count, makeTask, next, failure), "diacaustic-" + i);
            thread.setDaemon(true);
            started.add(thread);
        }
        started.forEach(Thread::start);
        join(started);
        rethrow(failure.get());
    }

    private void work(
            int count, Supplier<? extends Task> makeTask, AtomicInteger next, AtomicReference<Throwable> failure) {
        try {
            Task task = makeTask.get();
            for (int i = next.getAndIncrement(); i < count && !stop.isSet(); i = next.getAndIncrement()) {
                task.run(i);
            }
        } catch (RuntimeException | Error thrown) {
            failure.compareAndSet(null, thrown);
            stop.set();
        }
    }

    /** Waits for all threads, through interrupts, which stop the work. */
    private void join(List<Thread> running) {
        boolean interrupted = false;
        for (Thread thread : running) {
            while (thread.isAlive()) {
                try {
                    thread.join();
                } catch (InterruptedException wanted) {
                    interrupted = true;
                    stop.set();
                }
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private static void rethrow(Throwable thrown) {
        if (thrown instanceof Error error) {
            throw error;
        }
        if (thrown != null) {
            throw (RuntimeException) thrown;
        }
    }

    /** What one thread does, task after task. */
    @FunctionalInterface
    public interface Task {
        void run(int number);
    }
}
