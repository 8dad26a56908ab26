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
    /** Null if it is not kept. */
    private final OtherLight otherLight;

    private final Rgb otherSum = new Rgb();
    private final Rgb mapSum = new Rgb();
    private final Rgb difference = new Rgb();
    private int tilesDone;

    /**
     * @param pass which of the passes that are averaged this is
     * @param otherLight keeps what no map brings, or has it already; null if neither
     */
    TileRenderer(RenderPlan plan, Illumination light, int pass, PassMean picture, OtherLight otherLight) {
        this.plan = plan;
        this.pass = pass;
        this.picture = picture;
        this.otherLight = otherLight;
        this.tracer = new EyeTracer(plan, light, hasOtherLight());
    }

    private boolean hasOtherLight() {
        return otherLight != null && otherLight.isThere();
    }

    Counters counters() {
        return tracer.counters();
    }

    /** Tiles that were rendered to their end. */
    int tilesDone() {
        return tilesDone;
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
        tilesDone++;
        return true;
    }

    private boolean renderPixel(int x, int y, StopSignal stop) {
        Settings settings = plan.settings();
        Camera camera = plan.scene().camera();
        long pixel = (long) y * camera.width() + x;
        tracer.startPixel(pass, pixel);
        SampleStream random = tracer.random();
        int samples = settings.samples();
        boolean spread = samples > 1;
        boolean lens = camera.lensRadius() > 0;
        double shiftY = random.nextDouble();
        double lensShiftU = random.nextDouble();
        double lensShiftV = random.nextDouble();
        otherSum.set(0, 0, 0);
        mapSum.set(0, 0, 0);
        difference.set(0, 0, 0);
        for (int i = 0; i < samples; i++) {
            double across = spread ? (i + random.nextDouble()) / samples : 0.5;
            double down = spread ? Stratification.shiftedInverse(i, 2, shiftY) : 0.5;
            double lensU = lens ? Stratification.shiftedInverse(i, 3, lensShiftU) : 0;
            double lensV = lens ? Stratification.shiftedInverse(i, 5, lensShiftV) : 0;
            camera.aim(x + across, y + down, lensU, lensV, tracer.ray());
            // One sample tells well enough what another map would change.
            tracer.startSample(x + across, y + down, lensU, lensV, i == 0);
            Rgb other = tracer.trace(stop);
            if (stop.isSet()) {
                return false;
            }
            addSample(other, tracer.mapLight(), pixel);
            difference.add(tracer.difference());
        }
        Rgb radiance = exchange(x, y, otherSum.scale(1.0 / samples)).add(mapSum.scale(1.0 / samples));
        if (settings.clamps()) {
            radiance.set(Math.min(1, radiance.red), Math.min(1, radiance.green), Math.min(1, radiance.blue));
        }
        picture.add(pass, x, y, radiance);
        picture.addDifference(x, y, difference);
        return true;
    }

    /** Keeps what no map brings, or takes what was kept of it; rounded in either case, so that the picture is the same. */
    private Rgb exchange(int x, int y, Rgb radiance) {
        if (hasOtherLight()) {
            otherLight.recall(x, y, radiance);
            return radiance;
        }
        if (otherLight != null) {
            otherLight.keep(x, y, radiance);
        }
        return radiance.set((float) radiance.red, (float) radiance.green, (float) radiance.blue);
    }

    /** Adds a sample; what is infinite or not a number is counted and left out. */
    private void addSample(Rgb other, Rgb fromMap, long pixel) {
        boolean isFinite = addTo(mapSum, fromMap);
        isFinite &= addTo(otherSum, other);
        if (!isFinite) {
            Counters counters = tracer.counters();
            counters.nonFiniteSamples++;
            counters.firstNonFinitePixel = Math.min(counters.firstNonFinitePixel, pixel);
        }
    }

    private static boolean addTo(Rgb sum, Rgb radiance) {
        boolean isFinite =
                Double.isFinite(radiance.red) && Double.isFinite(radiance.green) && Double.isFinite(radiance.blue);
        if (isFinite) {
            sum.add(radiance);
        }
        return isFinite;
    }
}
