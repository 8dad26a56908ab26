package org.diacaustic.study;

import org.diacaustic.light.LightPoint;
import org.diacaustic.math.SampleStream;
import org.diacaustic.preprocess.Beam;
import org.diacaustic.preprocess.EmissionChart;
import org.diacaustic.preprocess.ForwardPass;
import org.diacaustic.preprocess.PreProcessor;

/**
 * One light ray at a random place in each of equal parts of light space. That has less noise than random rays, and the less
 * the more rays there are; and every ray has a chance of its own, so that pixels far from each other err independently and
 * their errors together tell how large they are. (A lattice shifted by chance has less noise still, but may err in all
 * pixels at once.) So that many rays can be spread evenly in little memory, a pass may be one of several that have a strip of
 * light space each. Belongs to one thread.
 */
final class JitteredPreProcessor implements PreProcessor {
    static final String NAME = "jittered";

    private final int strips;
    private int strip;

    /** @param strips how many passes share light space */
    JitteredPreProcessor(int strips) {
        this.strips = strips;
    }

    /** Says which strip the next pass has. */
    void turnTo(int number) {
        strip = number;
    }

    @Override
    public String name() {
        return NAME;
    }

    /** Rays carry the flux of the whole, as those of any pass do: the mean over all strips is the light. */
    @Override
    public void run(Beam beam, ForwardPass pass) {
        EmissionChart middle = beam.uniformChart(middle(beam));
        double aspect = middle.width() * strips / middle.height();
        long columns = Math.max(1, (long) Math.rint(Math.sqrt(beam.rays() * aspect)));
        long rows = Math.max(1, beam.rays() / columns);
        double share = 1.0 / (columns * rows);
        pass.shootRays(columns * rows, (number, emitter) -> {
            SampleStream random = emitter.random(number);
            EmissionChart chart = beam.uniformChart(emitter.point(random.nextDouble(), random.nextDouble()));
            double p = (number % columns + random.nextDouble()) / columns;
            double q = (strip + (number / columns + random.nextDouble()) / rows) / strips;
            chart.aim(p, q, emitter.ray());
            emitter.shoot(share);
        });
    }

    private static LightPoint middle(Beam beam) {
        LightPoint point = new LightPoint();
        beam.light().emitFrom(0.5, 0.5, point);
        return point;
    }
}
