package org.diacaustic.shape;

import java.util.function.DoubleFunction;
import org.diacaustic.math.Bounds;
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
    BOX(k -> new Box(at(k, -1, 0.25, -0.75), at(k, 0.5, 1, 2))),
    FAR_BOX(k -> new Box(at(k, 1e6, -1e6, 3e6), at(k, 1e6 + 1, -1e6 + 2, 3e6 + 1.5))),
    DISC(k -> new Disc(at(k, 0.1, 0.2, 0.3), new Vector3(1, 2, -0.5), 1.5 * k)),
    RING(k -> new Disc(at(k, 0.1, 0.2, 0.3), Vector3.UNIT_Z, 0.75 * k, 1.5 * k)),
    CYLINDER(k -> Frustum.cylinder(at(k, 0, 0, 0), at(k, 0, 2, 0), 0.75 * k, true)),
    LEANING_CYLINDER(k -> Frustum.cylinder(at(k, 100, 0, 0), at(k, 101, 2, -1), 0.5 * k, true)),
    OPEN_CYLINDER(k -> Frustum.cylinder(at(k, 1, 0.5, 0), at(k, 0.3, 2, 0.4), 0.75 * k, false)),
    CONE(k -> Frustum.cone(at(k, 0, 0, 0), 1.25 * k, at(k, 0.5, 2, 0.25), true)),
    OPEN_CONE(k -> Frustum.cone(at(k, 0, 0, 0), 1.25 * k, at(k, 0.5, 2, 0.25), false)),
    FRUSTUM(k -> Frustum.between(at(k, 0, 0, 1), 0.25 * k, at(k, 0.5, 2, 0.25), 1.5 * k, true)),
    TORUS(k -> new Torus(at(k, 0.1, 0.2, 0.3), Vector3.UNIT_Y, k, 0.25 * k)),
    FAT_TORUS(k -> new Torus(at(k, 0.1, 0.2, 0.3), new Vector3(1, 2, 3), 3 * k, 2.75 * k)),
    FAR_TORUS(k -> new Torus(at(k, 1e5, 2e5, -3e5), new Vector3(1, 2, 3), 3 * k, 0.5 * k)),
    MOVED_TORUS(k -> new Transformed(
            TORUS.make.apply(k), Transform.identity().scale(1, 2, 0.5).rotate(new Vector3(1, -2, 0.3), 77))),
    ROTATED_QUADRIC(k -> Quadric.of(1, 0.5, 0, 0.5 * k, 1, 0, 0, 1, -0.25 * k, -1 * k * k)),
    INVERTED_QUADRIC(k -> Quadric.of(-1, 0.5, 0, 0, -1, 0, 0, -2, 0, 3 * k * k)),
    PARABOLOID(k -> Quadric.of(1, 0, 0, 0, 0, 0, -0.5 * k, 1, 0, 0).within(new Bounds(-k, -k, -k, k, 0.75 * k, k))),
    HYPERBOLOID(k -> Quadric.of(1, 0, 0, 0, -1, 0, 0, 1, 0, -0.25 * k * k)
            .within(new Bounds(-3 * k, -2 * k, -3 * k, 3 * k, 2 * k, 3 * k))),
    MOVED_BOX(k -> new Transformed(
            new Box(at(k, -1, 0.25, -0.75), at(k, 0.5, 1, 2)),
            Transform.identity().rotate(new Vector3(1, -2, 0.3), 77).translate(at(k, 100, 200, -300)))),
    MOVED_CONE(k -> new Transformed(
            CONE.make.apply(k), Transform.identity().scale(1, -2, 0.25).translate(at(k, 3, 4, 5)))),
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
            Transform.identity().scale(1, 2, 3))),
    LENS(k -> new Combination(
            Combination.Kind.INTERSECTION,
            new Sphere(at(k, 0.3, -0.2, -0.8), 1.25 * k),
            new Sphere(at(k, 0.3, -0.2, 0.8), 1.25 * k))),
    BOWL(k -> new Combination(
            Combination.Kind.DIFFERENCE,
            new Combination(
                    Combination.Kind.DIFFERENCE,
                    new Sphere(at(k, 0.3, -0.2, 0.1), 1.25 * k),
                    new Sphere(at(k, 0.3, -0.2, 0.1), k)),
            new Box(at(k, -2, 0.25, -2), at(k, 2, 2, 2)))),
    JOINED_BOXES(k -> new Combination(
            Combination.Kind.UNION,
            new Box(at(k, -1, 0.25, -0.75), at(k, 0.3, 1, 2)),
            new Box(at(k, 0.3, 0.25, -0.75), at(k, 0.5, 1, 2)))),
    MOVED_DUMBBELL(k -> new Transformed(
            new Combination(
                    Combination.Kind.UNION,
                    new Combination(
                            Combination.Kind.UNION,
                            new Sphere(at(k, -1, 0, 0), 0.5 * k),
                            new Transformed(
                                    new Sphere(Vector3.ZERO, 0.5 * k),
                                    Transform.identity().translate(at(k, 1, 0, 0)))),
                    Frustum.cylinder(at(k, -1, 0, 0), at(k, 1, 0, 0), 0.2 * k, true)),
            Transform.identity().rotate(new Vector3(1, -2, 0.3), 77).translate(at(k, 10, -20, 30))));

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
        return this != OPEN_CYLINDER
                && this != OPEN_CONE
                && !isTorus()
                && this != PARABOLOID
                && this != HYPERBOLOID
                && this != BOWL
                && this != MOVED_DUMBBELL;
    }

    private boolean isTorus() {
        return name().endsWith("TORUS");
    }

    int mostCrossings() {
        return isTorus() || this == BOWL ? 4 : this == MOVED_DUMBBELL ? 6 : shape().isClosed() || !isConvex() ? 2 : 1;
    }
}
