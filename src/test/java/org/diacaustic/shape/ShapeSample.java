package org.diacaustic.shape;

import java.util.function.DoubleFunction;
import org.diacaustic.math.Transform;
import org.diacaustic.math.Vector3;

/** One of every shape, with every length a multiple of a factor, and what the contract test needs to know of it. */
enum ShapeSample {
    SPHERE(k -> new Sphere(at(k, 0.3, -0.2, 0.1), 1.25 * k)),
    FAR_SPHERE(k -> new Sphere(at(k, 3e6, -1e6, 2e6), 0.75 * k)),
    ELLIPSOID(k -> new Ellipsoid(at(k, 0.1, 0.2, 0.3), at(k, 1.5, 0.25, 0.8))),
    FLAT_ELLIPSOID(k -> new Ellipsoid(at(k, 0.1, 0.2, 0.3), at(k, 1.5, 1e-4, 0.8))),
    PLANE(k -> new Plane(at(k, 0.1, 0.2, 0.3), new Vector3(1, 2, -0.5))),
    TRIANGLE(k -> ConvexPolygon.twoSided(at(k, -1, 0, 0.2), at(k, 1, 0.1, 0), at(k, 0, 0.8, 0.7))),
    QUADRILATERAL(k ->
            ConvexPolygon.twoSided(at(k, -1, 0.5, -1), at(k, -1.5, 0.5, 1), at(k, 1, 0.5, 0.8), at(k, 1.2, 0.5, -0.9))),
    ONE_SIDED_HEXAGON(k -> ConvexPolygon.oneSided(
            at(k, 2, 0, 0), at(k, 1, 1, 0), at(k, -1, 1, 0), at(k, -2, 0, 0), at(k, -1, -1, 0), at(k, 1, -1, 0))),
    MOVED_SPHERE(k -> new Transformed(
            new Sphere(at(k, 0.5, 0, 0), 0.6 * k),
            Transform.identity()
                    .scale(2, 0.5, -1.5)
                    .rotate(new Vector3(1, 1, 0.3), 40)
                    .translate(at(k, 10, -20, 30)))),
    FAR_MOVED_SPHERE(k -> new Transformed(
            new Sphere(Vector3.ZERO, 0.6 * k),
            Transform.identity().rotate(new Vector3(1, 1, 0.3), 40).translate(at(k, 1e7, -2e7, 3e7)))),
    MOVED_QUADRILATERAL(k -> new Transformed(
            new Transformed(QUADRILATERAL.make.apply(k), Transform.identity().rotate(Vector3.UNIT_X, 30)),
            Transform.identity().scale(1, 2, 3)));

    private final DoubleFunction<Shape> make;

    ShapeSample(DoubleFunction<Shape> make) {
        this.make = make;
    }

    private static Vector3 at(double factor, double x, double y, double z) {
        return new Vector3(factor * x, factor * y, factor * z);
    }

    Shape shape() {
        return make.apply(1);
    }

    Shape scaled(double factor) {
        return make.apply(factor);
    }

    Vector3 centre() {
        return shape().bounds().isFinite() ? shape().bounds().centre() : Vector3.ZERO;
    }

    /** About the radius of the shape, or of the part of it that the tests look at. */
    double size() {
        return shape().bounds().isFinite() ? shape().bounds().radius() : 2;
    }

    /** The largest coordinate that takes part in a test. */
    double reach() {
        return centre().length() + 5 * size();
    }

    /** By how much more than a sphere the shape magnifies rounding. */
    double conditioning() {
        return this == FLAT_ELLIPSOID ? 1e4 : 4;
    }

    boolean isConvex() {
        return true;
    }

    int mostCrossings() {
        return shape().isClosed() ? 2 : 1;
    }
}
