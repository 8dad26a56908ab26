package org.diacaustic.trial;

import org.diacaustic.math.Bounds;
import org.diacaustic.math.Transform;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.Disc;
import org.diacaustic.shape.Ellipsoid;
import org.diacaustic.shape.FlakeKind;
import org.diacaustic.shape.Frustum;
import org.diacaustic.shape.MeshData;
import org.diacaustic.shape.Quadric;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.diacaustic.shape.Sphereflake;
import org.diacaustic.shape.Torus;
import org.diacaustic.shape.Transformed;
import org.diacaustic.shape.TriangleMesh;

/** Shapes of chance above the floor, of every kind there is. */
final class RandomShapes {
    private static final int KINDS = 11;

    /** The corners of an octahedron, and its faces, seen from outside. */
    private static final double[] OCTAHEDRON = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};

    private static final int[] FACES = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};

    private final RandomScene.Chance chance;
    private final Placing placing;

    RandomShapes(RandomScene.Chance chance, Placing placing) {
        this.chance = chance;
        this.placing = placing;
    }

    Shape next() {
        int kind = chance.below(KINDS);
        double x = chance.in(-2.5, 2.5);
        double y = chance.in(0.3, 2.5);
        double z = chance.in(-2.5, 2.5);
        double size = chance.in(0.2, 1);
        Vector3 home = new Vector3(x, y, z);
        Vector3 middle = placing.point(home);
        double radius = placing.length(size);
        Vector3 axis = chance.direction();
        return switch (kind) {
            case 0 -> new Box(placing.point(x - size, y - 0.3, z - 0.5), placing.point(x + size, y + 0.3, z + 0.5));
            case 1 ->
                new Ellipsoid(middle, new Vector3(radius, placing.length(chance.in(0.1, 1)), placing.length(0.5)));
            case 2 -> new Torus(middle, axis, radius, placing.length(size * chance.in(0.1, 0.9)));
            case 3 -> Frustum.cylinder(middle, placing.point(home.plus(axis.times(size))), placing.length(0.4), true);
            case 4 -> Frustum.cone(middle, radius, placing.point(home.plus(axis.times(1.2))), true);
            case 5 -> new Disc(middle, axis, radius);
            case 6 -> rough(x, y, z, size);
            case 7 ->
                new Transformed(
                        new Box(new Vector3(-radius, -radius, -radius), new Vector3(radius, radius, radius)),
                        Transform.identity().rotate(axis, chance.in(0, 180)).translate(middle));
            case 8 ->
                new Sphereflake(FlakeKind.CLASSIC, 1, middle, 0.5 * radius, 1.0 / 3, Vector3.UNIT_Y, Vector3.UNIT_X);
            case 9 -> bowl(x, y, z, size);
            default -> new Sphere(middle, radius);
        };
    }

    /** An octahedron with its corners pulled in or out, flat or smooth. */
    private TriangleMesh rough(double x, double y, double z, double size) {
        double[] vertices = new double[OCTAHEDRON.length];
        for (int i = 0; i < vertices.length; i += 3) {
            double reach = size * chance.in(0.6, 1.4);
            Vector3 corner = placing.point(
                    x + reach * OCTAHEDRON[i], y + reach * OCTAHEDRON[i + 1], z + reach * OCTAHEDRON[i + 2]);
            vertices[i] = corner.x();
            vertices[i + 1] = corner.y();
            vertices[i + 2] = corner.z();
        }
        return new TriangleMesh(new MeshData(vertices, FACES, null, null), chance.of(0.5));
    }

    /** The part of the paraboloid y′ = (x′² + z′²) ÷ size that lies in a box. */
    private Shape bowl(double x, double y, double z, double size) {
        double half = placing.length(size);
        Shape bowl = Quadric.of(1, 0, 0, 0, 0, 0, -0.5 * half, 1, 0, 0)
                .within(new Bounds(-half, 0, -half, half, half, half));
        return new Transformed(bowl, Transform.identity().translate(placing.point(x, y, z)));
    }
}
