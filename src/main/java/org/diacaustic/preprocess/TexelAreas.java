package org.diacaustic.preprocess;

import org.diacaustic.map.Chart;
import org.diacaustic.map.TexelGrid;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.parallel.Workers;
import org.diacaustic.shape.Shape;

/**
 * The true area of the surface behind every texel, by quadrature through the shape: lines of the chart at the middles of
 * sub-texels, and at every crossing the cross-section that the line stands for ÷ |cosine to the normal|. It
 * tends to the area as the lines get denser, wherever the lines do not run along the surface.
 */
final class TexelAreas {
    /** Lines to an object, if that makes at least 2 × 2 and at most 8 × 8 a texel. */
    private static final int LINES = 1 << 18;

    private final Shape shape;
    private final TexelGrid grid;
    private final Chart chart;
    private final int across;
    private final Crossings line = new Crossings();

    private TexelAreas(Shape shape, TexelGrid grid) {
        this.shape = shape;
        this.grid = grid;
        this.chart = grid.chart();
        this.across = (int) Math.max(2, Math.min(8, Math.sqrt((double) LINES / grid.size())));
    }

    /** Areas in squared scene units, by texel. */
    static double[] of(Shape shape, TexelGrid grid, Workers workers) {
        double[] areas = new double[grid.size()];
        workers.run(grid.rows(), () -> {
            TexelAreas task = new TexelAreas(shape, grid);
            return row -> task.fillRow(row, areas);
        });
        return areas;
    }

    private void fillRow(int row, double[] areas) {
        for (int column = 0; column < grid.columns(); column++) {
            areas[row * grid.columns() + column] = texelArea(column, row);
        }
    }

    private double texelArea(int column, int row) {
        double width = 1.0 / (grid.columns() * across);
        double height = 1.0 / (grid.rows() * across);
        double sum = 0;
        for (int i = 0; i < across; i++) {
            int line = row * across + i;
            double spread = chart.spread(width, line * height, (line + 1) * height);
            double sections = 0;
            for (int k = 0; k < across; k++) {
                chart.aim((column * across + k + 0.5) * width, (line + 0.5) * height, this.line.ray);
                sections += sections();
            }
            sum += spread * sections;
        }
        return sum;
    }

    /** The surface that the line crosses, per spread. */
    private double sections() {
        if (!chart.goesAround()) {
            startBefore(shape.bounds(), line.ray);
        }
        double sum = 0;
        while (line.next(shape)) {
            double cosine = Math.abs(line.cosine());
            if (cosine > 0) {
                sum += chart.sectionPerSpread(line.hit.x, line.hit.y, line.hit.z) / cosine;
            }
        }
        return sum;
    }

    /** Moves the start along the line to before the box. */
    private static void startBefore(Bounds bounds, Ray ray) {
        double x = bounds.minX() + (bounds.maxX() - bounds.minX()) / 2 - ray.originX;
        double y = bounds.minY() + (bounds.maxY() - bounds.minY()) / 2 - ray.originY;
        double z = bounds.minZ() + (bounds.maxZ() - bounds.minZ()) / 2 - ray.originZ;
        double middle = x * ray.directionX + y * ray.directionY + z * ray.directionZ;
        double start = middle - 2 * bounds.radius();
        ray.originX = Math.fma(start, ray.directionX, ray.originX);
        ray.originY = Math.fma(start, ray.directionY, ray.originY);
        ray.originZ = Math.fma(start, ray.directionZ, ray.originZ);
    }
}
