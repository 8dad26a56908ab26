package org.diacaustic.study;

import java.util.List;
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
        LightPoint point = new LightPoint();
        beam.light().emitFrom(0.5, 0.5, point);
        // Of a light with an extent each ray has a point of its own, and a chart.
        boolean hasExtent = beam.light().isVisible();
        List<EmissionChart> charts = hasExtent ? List.of(beam.uniformChart(point)) : beam.cubeCharts(point);
        double area = 0;
        for (EmissionChart chart : charts) {
            area += chart.width() * chart.height();
        }
        double step = Math.sqrt(area / strips / beam.rays());
        for (EmissionChart chart : charts) {
            long columns = Math.max(1, (long) Math.rint(chart.width() / step));
            long rows = Math.max(1, (long) Math.rint(chart.height() / strips / step));
            double share = 1.0 / (columns * rows);
            pass.shootRays(columns * rows, (number, emitter) -> {
                SampleStream random = emitter.random(number);
                long row = number / columns;
                long column = number % columns;
                double p = (column + random.nextDouble()) / columns;
                double q = (strip + (row + random.nextDouble()) / rows) / strips;
                LightPoint from = emitter.point(random.nextDouble(), random.nextDouble());
                (hasExtent ? beam.uniformChart(from) : chart).aim(p, q, emitter.ray());
                emitter.shoot(share);
            });
        }
    }
}
