package org.diacaustic.cli;

import java.nio.file.Path;
import java.util.Locale;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.ImageFormat;
import org.diacaustic.preprocess.ForwardPlan;
import org.diacaustic.render.Refined;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.render.Rendering;
import org.diacaustic.scene.MapName;

/** What a render says of itself: one line about the picture, and one for each thing that is not as it was asked. */
final class RenderReport {
    private RenderReport() {}

    static void print(Refined refined, Exposure exposure, Path target, double seconds) {
        Rendering rendering = refined.rendering();
        String line = line(refined, exposure, target, seconds);
        if (rendering.isComplete()) {
            System.out.println(line);
            refined.shortfall().ifPresent(shortfall -> System.err.println("diacaustic: " + shortfall));
        } else {
            System.err.printf(
                    Locale.ROOT,
                    "diacaustic: %s; saved %.0f %% of the picture as %s%n",
                    refined.end() == Refined.End.TIME
                            ? "the time is over before the first picture is done"
                            : "interrupted",
                    100.0 * rendering.tilesDone() / rendering.tilesTotal(),
                    line);
        }
        warnOfRadius(refined.plan(), rendering);
        rendering.nonFiniteReport().ifPresent(warning -> System.err.println("diacaustic: warning: " + warning));
    }

    private static void warnOfRadius(RenderPlan plan, Rendering rendering) {
        double asked = plan.settings().maps().gatherRadius();
        double taken = rendering.forward().gatherRadius();
        boolean gathers = plan.forward().map(ForwardPlan::map).orElse(MapName.NONE) == MapName.PHOTON_MAP;
        if (gathers && asked > 0 && taken != asked && rendering.isComplete()) {
            String radius = taken > 0 ? String.format(Locale.ROOT, "%.3g", taken) : "a part of the scene's extent";
            System.err.println("diacaustic: warning: most photons have no other within gather-radius " + asked
                    + "; took " + radius + ", as if none were given");
        }
    }

    private static String line(Refined refined, Exposure exposure, Path target, double seconds) {
        Rendering rendering = refined.rendering();
        StringBuilder line = new StringBuilder();
        line.append(String.format(
                Locale.ROOT,
                "%s: %d x %d, ",
                target,
                rendering.image().width(),
                rendering.image().height()));
        line.append(
                ImageFormat.of(target).isLinear()
                        ? "linear radiance"
                        : String.format(Locale.ROOT, "exposure %.6g", exposure.factor()));
        line.append(String.format(Locale.ROOT, ", %.2f s", seconds));
        if (rendering.isComplete()) {
            appendEstimate(rendering, line);
            appendAmount(refined, line);
        }
        return line.toString();
    }

    private static void appendEstimate(Rendering rendering, StringBuilder line) {
        if (!Double.isNaN(rendering.errorEstimate())) {
            line.append(", error about ").append(percent(rendering.errorEstimate()));
        } else if (!Double.isNaN(rendering.noiseEstimate())) {
            line.append(", noise about ").append(percent(rendering.noiseEstimate()));
        }
    }

    /** What is to be asked for to get the same picture again. */
    private static void appendAmount(Refined refined, StringBuilder line) {
        if (refined.rounds().isEmpty() || refined.plan().forward().isEmpty()) {
            return;
        }
        RenderPlan plan = refined.plan();
        line.append(", --map ").append(plan.settings().maps().map().label());
        if (plan.estimatesError()) {
            line.append(" --rays ").append(plan.settings().forward().rays());
        } else {
            line.append(" --passes ").append(plan.passes());
        }
    }

    private static String percent(double part) {
        return String.format(Locale.ROOT, "%.2g %%", 100 * part);
    }
}
