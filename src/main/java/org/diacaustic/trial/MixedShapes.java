package org.diacaustic.trial;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.material.Material;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Color;
import org.diacaustic.math.SampleStream;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Disc;
import org.diacaustic.shape.Ellipsoid;
import org.diacaustic.shape.FlakeKind;
import org.diacaustic.shape.Frustum;
import org.diacaustic.shape.Quadric;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.diacaustic.shape.Sphereflake;
import org.diacaustic.shape.Torus;
import org.diacaustic.shape.TriangleMesh;

/** Small shapes of every bounded kind by turns, at random places within the unit sphere. */
final class MixedShapes {
    private final SampleStream random;

    MixedShapes(SampleStream random) {
        this.random = random;
    }

    List<SceneObject> objects(int count) {
        List<SceneObject> objects = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            objects.add(object(shape(i % 12)));
        }
        return objects;
    }

    static SceneObject object(Shape shape) {
        return new SceneObject(
                "shape", shape, Material.builder().diffuse(Color.WHITE).build());
    }

    private Shape shape(int kind) {
        Vector3 at = direction().times(random.nextDouble());
        double size = size();
        Vector3 axis = direction();
        Vector3 aside = axis.perpendicular().times(size());
        Vector3 end = at.plus(axis.times(size()));
        return switch (kind) {
            case 0 -> new Sphere(at, size);
            case 1 -> new Ellipsoid(at, new Vector3(size, size(), size()));
            case 2 -> new Box(at, at.plus(new Vector3(size, size(), size())));
            case 3 -> new Torus(at, axis, size, size * (0.1 + 0.8 * random.nextDouble()));
            case 4 -> Frustum.cylinder(at, end, size, true);
            case 5 -> Frustum.cone(at, size, end, true);
            case 6 -> Frustum.between(at, size, end, size(), false);
            case 7 -> new Disc(at, axis, size / 3, size);
            case 8 -> ConvexPolygon.twoSided(at, at.plus(aside), end.plus(aside), end);
            case 9 -> paraboloid(at, size);
            case 10 -> new TriangleMesh(new Icosphere(1).data(at, size, 0.5, random), false);
            default -> new Sphereflake(FlakeKind.CLASSIC, 1, at, size / 2);
        };
    }

    /** (x² + z²) / size = y about a point, up to a height of its size. */
    private static Shape paraboloid(Vector3 at, double size) {
        double k = 1 / size;
        double constant = k * (at.x() * at.x() + at.z() * at.z()) + at.y();
        return Quadric.of(k, 0, 0, -k * at.x(), 0, 0, -0.5, k, -k * at.z(), constant)
                .within(new Bounds(at.x() - size, at.y(), at.z() - size, at.x() + size, at.y() + size, at.z() + size));
    }

    private Vector3 direction() {
        return DepartureTrials.random(random);
    }

    private double size() {
        return 0.02 + 0.08 * random.nextDouble();
    }
}
