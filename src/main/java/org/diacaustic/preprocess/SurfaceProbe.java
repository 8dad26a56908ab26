package org.diacaustic.preprocess;

import org.diacaustic.math.Bounds;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Shape;

/**
 * The area of a surface, and its area as a vector: the sum of area × normal, which is as long as the area if the surface is
 * flat and zero if it is closed. Measured by lines along the three axes: a line that stands for the cross-section c and
 * crosses at the cosine k to the normal tells of an area c/|k|, of which this direction is given the part k²; the
 * parts of the three directions make 1.
 */
record SurfaceProbe(double area, Vector3 vectorArea) {
    /** Lines on each side of a face of the box. */
    private static final int LINES = 32;

    static SurfaceProbe of(Shape shape) {
        Bounds bounds = shape.bounds();
        double sizeX = bounds.maxX() - bounds.minX();
        double sizeY = bounds.maxY() - bounds.minY();
        double sizeZ = bounds.maxZ() - bounds.minZ();
        double startX = bounds.minX() - sizeX;
        double startY = bounds.minY() - sizeY;
        double startZ = bounds.minZ() - sizeZ;
        Crossings line = new Crossings();
        double[] sums = new double[4];
        for (int i = 0; i < LINES; i++) {
            double a = (i + 0.5) / LINES;
            for (int k = 0; k < LINES; k++) {
                double b = (k + 0.5) / LINES;
                double x = bounds.minX() + a * sizeX;
                double y = bounds.minY() + b * sizeY;
                line.ray.set(startX, bounds.minY() + a * sizeY, bounds.minZ() + b * sizeZ, 1, 0, 0);
                add(shape, line, 0, sizeY * sizeZ, sums);
                line.ray.set(x, startY, bounds.minZ() + b * sizeZ, 0, 1, 0);
                add(shape, line, 1, sizeX * sizeZ, sums);
                line.ray.set(x, y, startZ, 0, 0, 1);
                add(shape, line, 2, sizeX * sizeY, sums);
            }
        }
        double section = 1.0 / (LINES * LINES);
        return new SurfaceProbe(
                sums[3] * section, new Vector3(sums[0] * section, sums[1] * section, sums[2] * section));
    }

    private static void add(Shape shape, Crossings line, int axis, double section, double[] sums) {
        while (line.next(shape)) {
            sums[axis] += Math.copySign(section, line.cosine());
            sums[3] += section * Math.abs(line.cosine());
        }
    }
}
