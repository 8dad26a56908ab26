package org.diacaustic.preprocess;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.light.LightPoint;
import org.diacaustic.math.SampleStream;
import org.diacaustic.scene.ForwardSettings;

/** Lays lattices of rays on charts. */
final class Lattices {
    private Lattices() {}

    /** Finds the charts of a light point. */
    interface Charting {
        List<EmissionChart> of(LightPoint from);
    }

    /**
     * Lattices for all points of the beam's light, with the same step on all charts of a point.
     *
     * @param rays points of the lattices together, about; not used if the settings give the size of a lattice
     * @param random for the shifts
     */
    static List<PointLattices> of(Beam beam, long rays, Charting charting, SampleStream random) {
        ForwardSettings settings = beam.settings();
        LightPoints points = new LightPoints(beam, random);
        List<PointLattices> all = new ArrayList<>();
        while (points.next()) {
            LightPoint from = new LightPoint();
            beam.light().emitFrom(points.s(), points.t(), from);
            List<EmissionChart> charts = charting.of(from);
            double area = 0;
            for (EmissionChart chart : charts) {
                area += chart.width() * chart.height();
            }
            double step = Math.sqrt(area * points.count() / rays);
            List<Lattice> lattices = new ArrayList<>();
            for (EmissionChart chart : charts) {
                int size = settings.latticeSize();
                int columns = size > 0 ? size : steps(chart.width(), step);
                int rows = size > 0 ? size : steps(chart.height(), step);
                double shiftP = settings.shiftsLattice() ? random.nextDouble() : 0;
                double shiftQ = settings.shiftsLattice() ? random.nextDouble() : 0;
                lattices.add(new Lattice(chart, columns, rows, shiftP, shiftQ));
            }
            all.add(new PointLattices(points.s(), points.t(), lattices));
        }
        return all;
    }

    static int steps(double length, double step) {
        return (int) Math.max(1, Math.min(1 << 20, Math.rint(length / step)));
    }

    /**
     * The lattices of one point of a light.
     *
     * @param s first coordinate of the point's choice
     * @param t second coordinate
     */
    record PointLattices(double s, double t, List<Lattice> lattices) {}
}
