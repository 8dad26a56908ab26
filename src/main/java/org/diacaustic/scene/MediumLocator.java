package org.diacaustic.scene;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Shape;

/**
 * Finds the media at a point: the closed transparent objects that hold it, the innermost last, and the medium that the
 * nearest open transparent surface declares on the point's side. For the eye and for lights, once a render.
 */
public final class MediumLocator {
    /** Any direction does; this one runs along no axis, face or diagonal that scenes are built on. */
    private static final Vector3 PROBE = new Vector3(0.2718, 0.8281, 0.4590).normalized();

    /** Some steps of arithmetic on coordinates, relative to their size. */
    private static final double ROUNDING = 0x1p-44;

    private MediumLocator() {}

    /** The media at {@code point}. */
    public static MediumStack locate(SceneIndex scene, Vector3 point) {
        List<Boundary> around = new ArrayList<>();
        Boundary sheet = null;
        for (int i = 0; i < scene.size(); i++) {
            if (scene.isOpaque(i)) {
                continue;
            }
            Shape shape = scene.object(i).shape();
            Bounds bounds = shape.bounds();
            if (shape.isClosed()) {
                if (bounds.contains(point.x(), point.y(), point.z())) {
                    Boundary boundary = boundary(i, shape, point, PROBE);
                    if (boundary != null && boundary.fromInside) {
                        around.add(boundary);
                    }
                }
            } else {
                Boundary boundary = boundary(i, shape, point, towards(shape, bounds, point));
                if (boundary != null && (sheet == null || boundary.distance < sheet.distance)) {
                    sheet = boundary;
                }
            }
        }
        MediumStack media = new MediumStack(scene);
        if (sheet != null) {
            var material = scene.object(sheet.object).material();
            media.setBase(sheet.fromInside ? material.inside() : material.outside());
        }
        around.sort(Comparator.comparingDouble(Boundary::distance).reversed());
        for (Boundary boundary : around) {
            media.cross(boundary.object, true);
        }
        return media;
    }

    /** The first opaque closed object that holds {@code point}: an eye there sees nothing else. */
    public static Optional<SceneObject> opaqueAround(List<SceneObject> objects, Vector3 point) {
        return objects.stream()
                .filter(object -> object.isOpaque() && object.shape().isClosed())
                .filter(object -> object.shape().bounds().contains(point.x(), point.y(), point.z()))
                .filter(object -> {
                    Boundary boundary = boundary(0, object.shape(), point, PROBE);
                    return boundary != null && boundary.fromInside;
                })
                .findFirst();
    }

    /** The first object whose surface {@code point} lies on, up to rounding: on which side it is would be chance. */
    public static Optional<SceneObject> surfaceAt(List<SceneObject> objects, Vector3 point) {
        return objects.stream().filter(object -> touches(object.shape(), point)).findFirst();
    }

    /** Whether a surface crosses one of the four diagonals through a point, no farther off than rounding may bring it. */
    private static boolean touches(Shape shape, Vector3 point) {
        Bounds bounds = shape.bounds();
        double size = bounds.isFinite() ? Math.max(point.length(), bounds.radius()) : point.length();
        double half = ROUNDING * size;
        Ray ray = new Ray();
        for (int i = 0; i < 4; i++) {
            Vector3 direction = new Vector3(
                    PROBE.x(), (i & 1) == 0 ? PROBE.y() : -PROBE.y(), (i & 2) == 0 ? PROBE.z() : -PROBE.z());
            ray.set(point.minus(direction.times(half)), direction);
            ray.tMax = 2 * half;
            if (shape.intersect(ray)) {
                return true;
            }
        }
        return false;
    }

    private static Vector3 towards(Shape shape, Bounds bounds, Vector3 point) {
        if (!bounds.isFinite()) {
            return PROBE;
        }
        Vector3 direction = bounds.centre().minus(point);
        return direction.length() > 0 ? direction.normalized() : PROBE;
    }

    private static Boundary boundary(int object, Shape shape, Vector3 point, Vector3 direction) {
        Ray ray = new Ray();
        ray.set(point, direction);
        if (!shape.intersect(ray)) {
            ray.set(point, direction.negated());
            if (shape.isClosed() || !shape.intersect(ray)) {
                return null;
            }
        }
        Hit hit = new Hit();
        hit.take(ray);
        shape.complete(ray, hit);
        double along = ray.directionX * hit.normalX + ray.directionY * hit.normalY + ray.directionZ * hit.normalZ;
        return new Boundary(object, ray.tMax, along > 0);
    }

    private record Boundary(int object, double distance, boolean fromInside) {}
}
