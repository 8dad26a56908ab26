package org.diacaustic.render;

import org.diacaustic.parallel.StopSignal;
import org.diacaustic.render.Refined.End;
import org.diacaustic.scene.Camera;

/** A caustic mesh made anew with more light rays, round after round. */
final class MeshRounds extends Rounds {
    /** Rays of the first round, if they are not given. */
    private static final long FIRST_RAYS = 1 << 16;

    /** As above if time is short: it is measured first. */
    private static final long FIRST_RAYS_IN_TIME = 1 << 12;

    /** With fewer rays an error may be small because nothing was found, and is not believed. */
    private static final long TRUSTED_RAYS = 1 << 14;

    private static final long MOST_RAYS = 1 << 30;

    /** A round with fewer times the rays of the last is not worth its time. */
    private static final double LEAST_GROWTH = 1.5;

    /** The part of the time left that a round is meant to take, as it may take longer. */
    private static final double CAREFUL = 0.85;

    /** A round that would be so many times the last is preceded by one between them, as so far nobody can see. */
    private static final double FAR = 16;

    /** As above, after the first round, which tells least. */
    private static final double FAR_AT_FIRST = 4;

    /** The part of all memory that maps may take: the collector needs some to work in. */
    private static final double MAPS_PART = 0.75;

    /** Null if each round is the mean of passes, which differ in it. */
    private final OtherLight otherLight;

    private final RayForecast forecast = new RayForecast();

    MeshRounds(RenderPlan plan, Goal goal, int threads, RoundSignal signal, ProgressListener listener) {
        super(plan, goal, threads, signal, listener);
        Camera camera = plan.scene().camera();
        this.otherLight = plan.passes() == 1 ? new OtherLight(camera.width(), camera.height()) : null;
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
    String stuck() {
        return "twice as many light rays, and more, bring it no further";
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
            if (rays >= TRUSTED_RAYS && goal.isReachedBy(rendering.errorEstimate())) {
                return End.DONE;
            }
            if (goal.error().isPresent() && forecast.isStuck()) {
                return End.NO_PROGRESS;
            }
            long possible = Math.min(MOST_RAYS, raysInMemory());
            long inTime = raysInTime();
            long wanted = goal.error().isPresent()
                    ? Math.max(TRUSTED_RAYS, forecast.raysForError(goal.error().getAsDouble()))
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
        if (goal.deadline().isPresent()) {
            return given > 0 ? Math.min(given, FIRST_RAYS_IN_TIME) : FIRST_RAYS_IN_TIME;
        }
        return given > 0 ? Math.max(given, TRUSTED_RAYS) : FIRST_RAYS;
    }

    private Rendering render(long rays) {
        RenderPlan round = plan.with(rays, plan.settings().forward().passes());
        long start = System.nanoTime();
        int passes = round.passes();
        StopSignal stop = signal.next();
        PassRun run = otherLight == null
                ? new PassRun(round, threads, stop, true)
                : new PassRun(round, threads, stop, otherLight);
        RenderProgress progress = new RenderProgress(round, passes, true, listener());
        for (int pass = 0; pass < passes; pass++) {
            run.render(progress);
        }
        Rendering rendering = run.rendering(passes);
        double seconds = (System.nanoTime() - start) * 1e-9;
        double error = rendering.isComplete() ? rendering.errorEstimate() : Double.NaN;
        keep(rendering, rays, passes);
        note(new Round(rays, passes, seconds, error));
        double lightSeconds =
                rendering.forward().traceSeconds() + rendering.forward().buildSeconds();
        forecast.add(new RayForecast.Measured(
                rays,
                error,
                lightSeconds,
                seconds - lightSeconds,
                rendering.counters().nodesExamined(),
                rendering.counters().intersectionTests(),
                otherLight == null ? 0 : rendering.counters().shadowTests,
                rendering.forward().mapBytes()));
        shareOtherLight(rendering);
        return rendering;
    }

    /** What the first round found for all the others, too. */
    private void shareOtherLight(Rendering rendering) {
        if (otherLight == null || !rendering.isComplete()) {
            return;
        }
        if (otherLight.isThere()) {
            otherLight.addCounts(rendering.counters());
        } else {
            otherLight.complete(rendering.counters());
        }
    }

    private long raysInMemory() {
        return forecast.raysForBytes(MAPS_PART * Runtime.getRuntime().maxMemory() - plan.imageBytes());
    }

    private long raysInTime() {
        if (goal.deadline().isEmpty()) {
            return Long.MAX_VALUE;
        }
        long fit = forecast.raysForSeconds(CAREFUL * goal.secondsLeft());
        double growth = (double) fit / forecast.rays();
        return growth > (forecast.isFirst() ? FAR_AT_FIRST : FAR) ? (long) (forecast.rays() * Math.sqrt(growth)) : fit;
    }
}
