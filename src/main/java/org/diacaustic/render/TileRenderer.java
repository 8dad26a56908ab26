package org.diacaustic.render;

import org.diacaustic.math.Rgb;
import org.diacaustic.math.SampleStream;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Settings;

/** Renders tiles of the picture, one after the other, for one thread. */
final class TileRenderer {
    private final RenderPlan plan;
    private final PassMean picture;
    private final int pass;
    private final EyeTracer tracer;
    private final Rgb sum = new Rgb();
    private final Rgb difference = new Rgb();

    /** @param pass which of the passes that are averaged this is */
    TileRenderer(RenderPlan plan, Illumination light, int pass, PassMean picture) {
        this.plan = plan;
        this.pass = pass;
        this.picture = picture;
        this.tracer = new EyeTracer(plan, light);
    }

    Counters counters() {
        return tracer.counters();
    }

    /**
     * Renders one tile.
     *
     * @return false if it was stopped before its end
     */
    boolean render(int tile, StopSignal stop) {
        tracer.startTask();
        Camera camera = plan.scene().camera();
        int left = tile % plan.tilesAcross() * RenderPlan.TILE_SIZE;
        int top = tile / plan.tilesAcross() * RenderPlan.TILE_SIZE;
        int right = Math.min(left + RenderPlan.TILE_SIZE, camera.width());
        int bottom = Math.min(top + RenderPlan.TILE_SIZE, camera.height());
        for (int y = top; y < bottom; y++) {
            for (int x = left; x < right; x++) {
                if (!renderPixel(x, y, stop)) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean renderPixel(int x, int y, StopSignal stop) {
        Settings settings = plan.settings();
        Camera camera = plan.scene().camera();
        long pixel = (long) y * camera.width() + x;
        SampleStream random = tracer.random();
        // Forward passes have the streams above 0.
        random.start(settings.seed(), -pass, pixel);
        int samples = settings.samples();
        boolean spread = samples > 1;
        boolean lens = camera.lensRadius() > 0;
        double shiftY = random.nextDouble();
        double lensShiftU = random.nextDouble();
        double lensShiftV = random.nextDouble();
        sum.set(0, 0, 0);
        difference.set(0, 0, 0);
        tracer.startPixel();
        for (int i = 0; i < samples; i++) {
            double across = spread ? (i + random.nextDouble()) / samples : 0.5;
            double down = spread ? Stratification.shiftedInverse(i, 2, shiftY) : 0.5;
            double lensU = lens ? Stratification.shiftedInverse(i, 3, lensShiftU) : 0;
            double lensV = lens ? Stratification.shiftedInverse(i, 5, lensShiftV) : 0;
            camera.aim(x + across, y + down, lensU, lensV, tracer.ray());
            // One sample tells well enough what another map would change.
            tracer.startSample(x + across, y + down, lensU, lensV, i == 0);
            Rgb radiance = tracer.trace(stop);
            if (stop.isSet()) {
                return false;
            }
            add(radiance, pixel);
            difference.add(tracer.difference());
        }
        sum.scale(1.0 / samples);
        if (settings.clamps()) {
            sum.set(Math.min(1, sum.red), Math.min(1, sum.green), Math.min(1, sum.blue));
        }
        picture.add(pass, x, y, sum);
        picture.addDifference(x, y, difference);
        return true;
    }

    /** Adds a sample; one that is infinite or not a number is counted and left out. */
    private void add(Rgb radiance, long pixel) {
        if (Double.isFinite(radiance.red) && Double.isFinite(radiance.green) && Double.isFinite(radiance.blue)) {
            sum.add(radiance);
        } else {
            Counters counters = tracer.counters();
            counters.nonFiniteSamples++;
            counters.firstNonFinitePixel = Math.min(counters.firstNonFinitePixel, pixel);
        }
    }
}
