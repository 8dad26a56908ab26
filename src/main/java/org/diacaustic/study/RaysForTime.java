package org.diacaustic.study;

import org.diacaustic.parallel.StopSignal;

/** Finds by trying how many light rays a picture may have that is to take a given time. */
final class RaysForTime {
    static final long FIRST_TRIAL = 4096;

    /** From trial to trial. */
    private static final int STEP = 4;

    /** A trial that takes this part of the time tells enough. */
    private static final double ENOUGH = 0.3;

    private static final long MOST = 1L << 40;

    private RaysForTime() {}

    /** @return at least 1; more rays cost what the last two trials say that they cost */
    static long of(double seconds, TechniqueRender render, long seed, StopSignal stop) {
        long rays = FIRST_TRIAL;
        double before = 0;
        double taken = seconds(rays, render, seed);
        while (taken < ENOUGH * seconds && rays < MOST && !stop.isSet()) {
            before = taken;
            rays *= STEP;
            taken = seconds(rays, render, seed);
        }
        double fewer = before == 0 ? 0 : (double) rays / STEP;
        double secondsARay = Math.max((taken - before) / (rays - fewer), 0.5 * taken / rays);
        long foretold = Math.max(1, Math.min(MOST, (long) (rays + (seconds - taken) / secondsARay)));
        if (stop.isSet()) {
            return foretold;
        }
        // A single slow trial may have said too much; one of the whole length says how much.
        double correction = Math.max(1.0 / STEP, Math.min(STEP, seconds / seconds(foretold, render, seed)));
        return Math.max(1, (long) Math.min(MOST, foretold * correction));
    }

    private static double seconds(long rays, TechniqueRender render, long seed) {
        Clock clock = new Clock();
        render.render(rays, seed);
        return clock.wallSeconds();
    }
}
