package org.diacaustic.preprocess;

import java.util.concurrent.atomic.LongAdder;
import java.util.function.IntToLongFunction;
import java.util.function.Supplier;
import org.diacaustic.map.PhotonCapacityException;
import org.diacaustic.math.SampleStream;
import org.diacaustic.parallel.Workers;

/**
 * Foretells how much a pass would store, from a few of its tasks, so that a pass for which there is no room ends before it
 * has filled the memory. Asked only where more rays are planned than things have room.
 */
final class StoreForecast {
    /** Tasks that are tried, spread evenly over all. */
    private static final int TRIED = 32;

    /** What is expected must be as many times what there is room for: less is left to be found out. */
    private static final double SURE = 2;

    private StoreForecast() {}

    /**
     * Tries tasks, whose results nobody keeps.
     *
     * @param what is stored, for messages
     * @param before how much is stored already
     * @param makeTrial called once by each thread: runs a task and gives how much that stores
     * @throws PhotonCapacityException if there is no room for what is expected
     */
    static void requireRoom(
            String what, int capacity, long before, int tasks, Workers workers, Supplier<IntToLongFunction> makeTrial) {
        int tried = Math.min(TRIED, tasks);
        LongAdder stored = new LongAdder();
        workers.run(tried, () -> {
            IntToLongFunction trial = makeTrial.get();
            SampleStream random = new SampleStream();
            return i -> stored.add(trial.applyAsLong((int) (place(i, tried, random) * tasks)));
        });
        double expected = before + (double) stored.sum() / tried * tasks;
        if (expected > SURE * capacity && !workers.stop().isSet()) {
            throw new PhotonCapacityException(what, expected, capacity);
        }
    }

    /** Somewhere in the i-th of equal parts, 0 to 1: even steps could be in line with rows that tasks are cut from. */
    private static double place(int i, int parts, SampleStream random) {
        random.start(0, i, parts);
        return (i + random.nextDouble()) / parts;
    }
}
