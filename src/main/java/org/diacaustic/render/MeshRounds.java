package org.diacaustic.render;

import org.diacaustic.render.Refined.End;

/** A caustic mesh made anew with more light rays, round after round. */
final class MeshRounds extends Rounds {
    /** Rays of the first round, if they are not given. */
    private static final long FIRST_RAYS = 1 << 16;

    /** As above if time is short: it is measured first. */
    private static final long FIRST_RAYS_IN_TIME = 1 << 14;

    private static final long MOST_RAYS = 1 << 30;

    /** A round with fewer times the rays of the last is not worth its time. */
    private static final double LEAST_GROWTH = 1.5;

    /** The part of the time left that a round is meant to take, as it may take longer. */
    private static final double CAREFUL = 0.85;

    /** If there is so much more time than the last round took, the next one measures again before all is spent on one. */
    private static final double MUCH = 20;

    private static final double MEASURING_PART = 1.0 / 6;

    /** The part of all memory that maps may take: the collector needs some to work in. */
    private static final double MAPS_PART = 0.75;

    private final RayForecast forecast = new RayForecast();
    private double lastSeconds;

    MeshRounds(RenderPlan plan, Goal goal, int threads, RoundSignal signal, ProgressListener listener) {
        super(plan, goal, threads, signal, listener);
    }

    @Override
    String counted() {
        return "light rays";
    }

    @Override
    String estimated() {
        return "error";
    }

    @Override
    End renderAll() {
        long rays = firstRays();
        while (true) {
            Rendering rendering;
            try {
                rendering = render(rays);
            } catch (ResourceLimitException | OutOfMemoryError tooMuch) {
                if (picture() == null) {
                    throw tooMuch;
                }
                return End.MEMORY;
            }
            if (!rendering.isComplete()) {
                return signal.end();
            }
            if (goal.isReachedBy(rendering.errorEstimate())) {
                return End.DONE;
            }
            if (goal.error().isPresent() && forecast.isStuck()) {
                return End.NO_PROGRESS;
            }
            long possible = Math.min(MOST_RAYS, raysInMemory());
            long inTime = raysInTime();
            long wanted = goal.error().isPresent()
                    ? forecast.raysForError(goal.error().getAsDouble())
                    : Long.MAX_VALUE;
            long next = Math.min(wanted, Math.min(possible, inTime));
            if (next < LEAST_GROWTH * rays) {
                return inTime < possible ? End.TIME : possible < MOST_RAYS ? End.MEMORY : End.COUNT;
            }
            rays = next;
        }
    }

    private long firstRays() {
        long given = plan.settings().forward().rays();
        if (given > 0) {
            return given;
        }
        return goal.deadline().isPresent() ? FIRST_RAYS_IN_TIME : FIRST_RAYS;
    }

    private Rendering render(long rays) {
        RenderPlan round = plan.with(rays, plan.settings().forward().passes());
        long start = System.nanoTime();
        int passes = round.passes();
        PassRun run = new PassRun(round, threads, signal.next(), passes > 1);
        RenderProgress progress = new RenderProgress(round, passes, true, listener());
        for (int pass = 0; pass < passes; pass++) {
            run.render(progress);
        }
        Rendering rendering = run.rendering(passes);
        lastSeconds = (System.nanoTime() - start) * 1e-9;
        double error = rendering.isComplete() ? rendering.errorEstimate() : Double.NaN;
        keep(rendering, rays, passes);
        note(new Round(rays, passes, lastSeconds, error));
        double lightSeconds =
                rendering.forward().traceSeconds() + rendering.forward().buildSeconds();
        forecast.add(new RayForecast.Measured(
                rays,
                error,
                lightSeconds,
                lastSeconds - lightSeconds,
                rendering.forward().mapBytes()));
        return rendering;
    }

    private long raysInMemory() {
        return forecast.raysForBytes(MAPS_PART * Runtime.getRuntime().maxMemory() - plan.imageBytes());
    }

    private long raysInTime() {
        double left = goal.secondsLeft();
        if (left == Double.POSITIVE_INFINITY) {
            return Long.MAX_VALUE;
        }
        return forecast.raysForSeconds(left > MUCH * lastSeconds ? MEASURING_PART * left : CAREFUL * left);
    }
}
