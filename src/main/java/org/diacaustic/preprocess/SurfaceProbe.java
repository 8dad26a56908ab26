package org.diacaustic.preprocess;

import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Shape;

/**
 * The area of a surface, and its area as a vector: the sum of area × normal, which is as long as the area if the surface is
 * flat and zero if it is closed. Roughly, for choices.
 */
record SurfaceProbe(double area, Vector3 vectorArea) {
    private static final int LINES = 32;

    static SurfaceProbe of(Shape shape) {
        double[] sums = new double[4];
        AxisLines.visit(shape, LINES, (line, area) -> {
            Hit hit = line.hit;
            sums[0] += area * hit.normalX;
            sums[1] += area * hit.normalY;
            sums[2] += area * hit.normalZ;
            sums[3] += area;
        });
        return new SurfaceProbe(sums[3], new Vector3(sums[0], sums[1], sums[2]));
    }
}
