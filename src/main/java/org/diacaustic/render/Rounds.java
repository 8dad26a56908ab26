package org.diacaustic.render;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.diacaustic.render.Refined.End;

/** The rounds of a refinement: what all ways to go on have in common. */
abstract class Rounds {
    final RenderPlan plan;
    final Goal goal;
    final int threads;
    final RoundSignal signal;

    private final ProgressListener listener;
    private final FractionProgress time;
    private final double seconds;
    private final List<Round> rounds = new ArrayList<>();
    private Rendering picture;
    private long rays;
    private int passes;

    Rounds(RenderPlan plan, Goal goal, int threads, RoundSignal signal, ProgressListener listener) {
        this.plan = plan;
        this.goal = goal;
        this.threads = threads;
        this.signal = signal;
        // With a deadline, how much of the time is over says more than any part of the work.
        this.time = new FractionProgress(listener);
        this.listener = goal.deadline().isEmpty() ? listener : (done, total) -> time.at(timeOver());
        this.seconds = goal.secondsLeft();
    }

    private double timeOver() {
        return 1 - goal.secondsLeft() / seconds;
    }

    /** Renders all rounds. */
    final Refined run() {
        End end = renderAll();
        if (goal.deadline().isPresent()) {
            time.at(1);
        }
        return new Refined(picture, plan.with(rays, passes), List.copyOf(rounds), end, shortfall(end));
    }

    /** Renders round after round, until there is a reason not to. */
    abstract End renderAll();

    /** What there is more of from round to round. */
    abstract String counted();

    /** What is estimated. */
    abstract String estimated();

    /** What no progress means. */
    abstract String stuck();

    /** Who is to hear how far a round is. */
    final ProgressListener listener() {
        return listener;
    }

    /** The last whole picture, or what there is of the first; null before. */
    final Rendering picture() {
        return picture;
    }

    /** Takes a picture in place of the last, if it is whole or the first. */
    final void keep(Rendering rendering, long lightRays, int passesDone) {
        if (rendering.isComplete() || picture == null) {
            picture = rendering;
            rays = lightRays;
            passes = passesDone;
        }
    }

    /** Notes a round. */
    final void note(Round round) {
        rounds.add(round);
    }

    private Optional<String> shortfall(End end) {
        if (!picture.isComplete()) {
            double part = (double) picture.tilesDone() / picture.tilesTotal();
            return Optional.of(
                    end == End.TIME
                            ? String.format(
                                    Locale.ROOT, "the time is over with %.0f %% of the first picture done", 100 * part)
                            : "it was cancelled before the first picture was done");
        }
        if (end == End.DONE || goal.error().isEmpty() && end != End.CANCELLED) {
            return Optional.empty();
        }
        double estimate = Refined.estimate(picture);
        String reached = Double.isNaN(estimate) ? "it cannot be told" : "about " + percent(estimate) + " is reached";
        String asked = goal.error().isPresent() ? " of " + percent(goal.error().getAsDouble()) + " was asked for" : "";
        return Optional.of(estimated() + asked + ", " + reached + ": " + reason(end));
    }

    private String reason(End end) {
        return switch (end) {
            case TIME -> "there is no time for more " + counted();
            case MEMORY -> "more " + counted() + " do not fit in memory; java may use more with -Xmx";
            case COUNT -> "there cannot be more " + counted();
            case NO_PROGRESS -> stuck();
            default -> "it was cancelled";
        };
    }

    private static String percent(double part) {
        return String.format(Locale.ROOT, "%.2g %%", 100 * part);
    }
}
