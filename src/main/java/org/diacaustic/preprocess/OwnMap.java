package org.diacaustic.preprocess;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.diacaustic.map.Chart;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.SampleStream;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Shape;

/**
 * The charts whose lines find the points of one object's surface: the object's own, and, where lines of that graze the
 * surface, also parallels to the three axes, one of which does not graze. Immutable.
 *
 * @param object its number in the scene
 * @param charts the own one first
 */
record OwnMap(int object, Shape shape, List<Chart> charts) {
    /** The cosine below which a line of the chart grazes. */
    private static final double GRAZING = 0.25;

    private static final int GRAZE_LINES = 16;

    /** The map of an object whose shape has bounds; empty if it has no surface. */
    static Optional<OwnMap> of(int number, SceneObject object) {
        return SurfaceChart.of(object).map(own -> {
            List<Chart> charts = new ArrayList<>();
            charts.add(own.chart());
            if (isGrazed(object.shape(), own.chart())) {
                addAxes(object.shape().bounds(), charts);
            }
            return new OwnMap(number, object.shape(), List.copyOf(charts));
        });
    }

    private static boolean isGrazed(Shape shape, Chart chart) {
        boolean[] found = new boolean[1];
        Ray own = new Ray();
        AxisLines.visit(shape, GRAZE_LINES, (line, area) -> {
            Hit at = line.hit;
            chart.aim(chart.u(at.x, at.y, at.z), chart.v(at.x, at.y, at.z), own);
            found[0] |=
                    Math.abs(own.directionX * at.normalX + own.directionY * at.normalY + own.directionZ * at.normalZ)
                            < GRAZING;
        });
        return found[0];
    }

    /** The lines through the faces of the box. */
    private static void addAxes(Bounds box, List<Chart> charts) {
        Vector3 low = new Vector3(box.minX(), box.minY(), box.minZ());
        Vector3 x = Vector3.UNIT_X.times(box.maxX() - box.minX());
        Vector3 y = Vector3.UNIT_Y.times(box.maxY() - box.minY());
        Vector3 z = Vector3.UNIT_Z.times(box.maxZ() - box.minZ());
        addFace(low, y, z, charts);
        addFace(low, z, x, charts);
        addFace(low, x, y, charts);
    }

    /** What is flat shows no face to lines that run in it. */
    private static void addFace(Vector3 low, Vector3 sideU, Vector3 sideV, List<Chart> charts) {
        if (sideU.length() > 0 && sideV.length() > 0) {
            charts.add(Chart.planar(low, sideU, sideV));
        }
    }

    /**
     * Lattices of about so many lines together: half of them the chart's own, if there are others, and the others equally dense.
     *
     * @param side points along each side of every lattice instead; 0: not given
     * @param random for their shifts; null aligns them left
     */
    List<LineLattice> lattices(double lines, int side, SampleStream random) {
        double axes = charts.stream().skip(1).mapToDouble(OwnMap::area).sum();
        List<LineLattice> lattices = new ArrayList<>();
        for (int i = 0; i < charts.size(); i++) {
            Chart chart = charts.get(i);
            double share = charts.size() == 1 ? 1 : i == 0 ? 0.5 : 0.5 * area(chart) / axes;
            double step = Math.sqrt(width(chart) * height(chart) / (lines * share));
            int columns = side > 0 ? side : Lattices.steps(width(chart), step);
            int rows = side > 0 ? side : Lattices.steps(height(chart), step);
            lattices.add(new LineLattice(chart, columns, rows, random));
        }
        return lattices;
    }

    private static double area(Chart chart) {
        return width(chart) * height(chart);
    }

    /** The extent of a chart along u: around a point, where rows are of equal height, that of a cylinder around it. */
    private static double width(Chart chart) {
        return chart.goesAround() ? Math.PI : distance(chart, 1, 0);
    }

    private static double height(Chart chart) {
        return chart.goesAround() ? 1 : distance(chart, 0, 1);
    }

    private static double distance(Chart chart, double u, double v) {
        Ray start = new Ray();
        Ray end = new Ray();
        chart.aim(0, 0, start);
        chart.aim(u, v, end);
        return new Vector3(end.originX - start.originX, end.originY - start.originY, end.originZ - start.originZ)
                .length();
    }

    /**
     * Visits all crossings of a lattice's lines first to end − 1 with the surface. The area that a crossing stands for is 1 ÷ the
     * density of the lines of all lattices there: lines that graze count for little where others do not.
     */
    void cross(List<LineLattice> lattices, int which, long first, long end, AxisLines.Visitor visitor) {
        Crossings line = new Crossings();
        Ray other = new Ray();
        LineLattice lattice = lattices.get(which);
        for (long i = first; i < end; i++) {
            lattice.aim(i, line.ray);
            if (!lattice.startsInside()) {
                line.startBefore(shape.bounds());
            }
            while (line.next(shape)) {
                double density = lattice.density(line.hit, line.cosine());
                for (int k = 0; k < lattices.size(); k++) {
                    density += k == which ? 0 : lattices.get(k).density(line.hit, other);
                }
                if (density > 0) {
                    visitor.crossing(line, 1 / density);
                }
            }
        }
    }
}
