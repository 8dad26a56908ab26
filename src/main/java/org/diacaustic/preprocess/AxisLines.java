package org.diacaustic.preprocess;

import org.diacaustic.math.Bounds;
import org.diacaustic.shape.Shape;

/**
 * Every crossing of a surface with evenly spread lines along the three axes. A line that stands for the cross-section c and
 * crosses at the cosine k to the normal tells of an area c/|k|, of which its direction is given the part k²: c·|k|. The
 * parts of the three directions make 1, and no line counts for too much where it only grazes the surface.
 */
final class AxisLines {
    /** Irrational, so that no edge runs along a row of lines. */
    static final double SHEAR = (Math.sqrt(5) - 1) / 2;

    private final Shape shape;
    private final Bounds bounds;
    private final Crossings line = new Crossings();
    private final Visitor visitor;

    private AxisLines(Shape shape, Visitor visitor) {
        this.shape = shape;
        this.bounds = shape.bounds();
        this.visitor = visitor;
    }

    /** @param lines on each side of a face of the box around the shape, which must be finite */
    static void visit(Shape shape, int lines, Visitor visitor) {
        AxisLines task = new AxisLines(shape, visitor);
        for (int i = 0; i < lines; i++) {
            for (int k = 0; k < lines; k++) {
                double across = (k + 0.5) / lines;
                double sheared = i * SHEAR + across;
                task.follow((i + 0.5) / lines, sheared - Math.floor(sheared), 1.0 / ((double) lines * lines));
            }
        }
    }

    private void follow(double a, double b, double share) {
        double sizeX = bounds.maxX() - bounds.minX();
        double sizeY = bounds.maxY() - bounds.minY();
        double sizeZ = bounds.maxZ() - bounds.minZ();
        double before = bounds.radius();
        line.ray.set(bounds.minX() - before, bounds.minY() + a * sizeY, bounds.minZ() + b * sizeZ, 1, 0, 0);
        visitAll(sizeY * sizeZ * share);
        line.ray.set(bounds.minX() + b * sizeX, bounds.minY() - before, bounds.minZ() + a * sizeZ, 0, 1, 0);
        visitAll(sizeX * sizeZ * share);
        line.ray.set(bounds.minX() + a * sizeX, bounds.minY() + b * sizeY, bounds.minZ() - before, 0, 0, 1);
        visitAll(sizeX * sizeY * share);
    }

    private void visitAll(double section) {
        while (line.next(shape)) {
            visitor.crossing(line, section * Math.abs(line.cosine()));
        }
    }

    /** Is told of each crossing and of the area that it stands for, in squared scene units. */
    @FunctionalInterface
    interface Visitor {
        void crossing(Crossings at, double area);
    }
}
