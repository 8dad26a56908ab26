package org.diacaustic.math;

/**
 * Random numbers for one small piece of work, found from its place in the whole and nothing else: the same (seed, task,
 * index) gives the same numbers in any order and on any number of threads. It is a SplitMix64 generator [Steele, Lea and
 * Flood 2014, "Fast Splittable Pseudorandom Number Generators"] whose start is a hash of the three.
 */
public final class SampleStream {
    private static final long GOLDEN = 0x9E3779B97F4A7C15L;

    private long state;

    /** Goes to the start of the stream (seed, task, index). */
    public void start(long seed, long task, long index) {
        state = mix(mix(mix(seed + GOLDEN) + task * GOLDEN) + index * GOLDEN);
    }

    public long nextLong() {
        state += GOLDEN;
        return mix(state);
    }

    /** Uniform in [0, 1), a multiple of 2^-53. */
    public double nextDouble() {
        return (nextLong() >>> 11) * 0x1p-53;
    }

    private static long mix(long value) {
        long z = (value ^ (value >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }
}
