package org.diacaustic.shape;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Vector3;

/**
 * The yardstick of the benchmarks: ray casting as one writes it first, with an object for every node, primitive and hit,
 * a tree split at the median of the longest axis, and Möller and Trumbore's triangle test.
 */
final class PlainCaster {
    private static final int LEAF_SIZE = 4;

    /** What a cast returns, or null. */
    record PlainHit(double t, Primitive primitive) {}

    private record PlainRay(Vector3 origin, Vector3 direction, Vector3 inverse) {}

    private interface Primitive {
        Bounds bounds();

        PlainHit hit(PlainRay ray, double tMax);
    }

    private record Triangle(Vector3 a, Vector3 b, Vector3 c) implements Primitive {
        @Override
        public Bounds bounds() {
            return Bounds.of(a, b, c);
        }

        @Override
        public PlainHit hit(PlainRay ray, double tMax) {
            double e1x = b.x() - a.x();
            double e1y = b.y() - a.y();
            double e1z = b.z() - a.z();
            double e2x = c.x() - a.x();
            double e2y = c.y() - a.y();
            double e2z = c.z() - a.z();
            Vector3 d = ray.direction;
            double px = d.y() * e2z - d.z() * e2y;
            double py = d.z() * e2x - d.x() * e2z;
            double pz = d.x() * e2y - d.y() * e2x;
            double determinant = e1x * px + e1y * py + e1z * pz;
            if (determinant == 0) {
                return null;
            }
            double sx = ray.origin.x() - a.x();
            double sy = ray.origin.y() - a.y();
            double sz = ray.origin.z() - a.z();
            double u = (sx * px + sy * py + sz * pz) / determinant;
            if (u < 0 || u > 1) {
                return null;
            }
            double qx = sy * e1z - sz * e1y;
            double qy = sz * e1x - sx * e1z;
            double qz = sx * e1y - sy * e1x;
            double v = (d.x() * qx + d.y() * qy + d.z() * qz) / determinant;
            if (v < 0 || u + v > 1) {
                return null;
            }
            double t = (e2x * qx + e2y * qy + e2z * qz) / determinant;
            return t > 0 && t < tMax ? new PlainHit(t, this) : null;
        }
    }

    private record Ball(Vector3 centre, double radius) implements Primitive {
        @Override
        public Bounds bounds() {
            return Bounds.around(centre, radius, radius, radius);
        }

        @Override
        public PlainHit hit(PlainRay ray, double tMax) {
            double fx = ray.origin.x() - centre.x();
            double fy = ray.origin.y() - centre.y();
            double fz = ray.origin.z() - centre.z();
            Vector3 d = ray.direction;
            double b = fx * d.x() + fy * d.y() + fz * d.z();
            double discriminant = b * b - (fx * fx + fy * fy + fz * fz - radius * radius);
            if (discriminant < 0) {
                return null;
            }
            double root = Math.sqrt(discriminant);
            double t = -b - root > 0 ? -b - root : -b + root;
            return t > 0 && t < tMax ? new PlainHit(t, this) : null;
        }
    }

    private record Node(Bounds bounds, Node left, Node right, List<Primitive> primitives) {

        static Node of(List<Primitive> primitives) {
            Bounds bounds = Bounds.EMPTY;
            for (Primitive primitive : primitives) {
                bounds = bounds.union(primitive.bounds());
            }
            if (primitives.size() <= LEAF_SIZE) {
                return new Node(bounds, null, null, primitives);
            }
            double x = bounds.maxX() - bounds.minX();
            double y = bounds.maxY() - bounds.minY();
            double z = bounds.maxZ() - bounds.minZ();
            Comparator<Primitive> byCentre = x >= y && x >= z
                    ? Comparator.comparingDouble(p -> p.bounds().centre().x())
                    : y >= z
                            ? Comparator.comparingDouble(
                                    p -> p.bounds().centre().y())
                            : Comparator.comparingDouble(
                                    p -> p.bounds().centre().z());
            List<Primitive> sorted = new ArrayList<>(primitives);
            sorted.sort(byCentre);
            int middle = sorted.size() / 2;
            return new Node(
                    bounds,
                    of(new ArrayList<>(sorted.subList(0, middle))),
                    of(new ArrayList<>(sorted.subList(middle, sorted.size()))),
                    List.of());
        }

        PlainHit hit(PlainRay ray, double tMax) {
            if (left == null) {
                PlainHit nearest = null;
                for (Primitive primitive : primitives) {
                    PlainHit hit = primitive.hit(ray, nearest == null ? tMax : nearest.t);
                    nearest = hit == null ? nearest : hit;
                }
                return nearest;
            }
            double toLeft = entry(left.bounds, ray, tMax);
            double toRight = entry(right.bounds, ray, tMax);
            boolean leftFirst = toLeft <= toRight;
            PlainHit nearest = null;
            if (Math.min(toLeft, toRight) < tMax) {
                nearest = (leftFirst ? left : right).hit(ray, tMax);
            }
            double limit = nearest == null ? tMax : nearest.t;
            if (Math.max(toLeft, toRight) < limit) {
                PlainHit hit = (leftFirst ? right : left).hit(ray, limit);
                nearest = hit == null ? nearest : hit;
            }
            return nearest;
        }

        private static double entry(Bounds box, PlainRay ray, double tMax) {
            double x0 = (box.minX() - ray.origin.x()) * ray.inverse.x();
            double x1 = (box.maxX() - ray.origin.x()) * ray.inverse.x();
            double y0 = (box.minY() - ray.origin.y()) * ray.inverse.y();
            double y1 = (box.maxY() - ray.origin.y()) * ray.inverse.y();
            double z0 = (box.minZ() - ray.origin.z()) * ray.inverse.z();
            double z1 = (box.maxZ() - ray.origin.z()) * ray.inverse.z();
            double near = Math.max(Math.max(Math.min(x0, x1), Math.min(y0, y1)), Math.max(Math.min(z0, z1), 0));
            double far = Math.min(Math.min(Math.max(x0, x1), Math.max(y0, y1)), Math.min(Math.max(z0, z1), tMax));
            return near <= far ? near : Double.POSITIVE_INFINITY;
        }
    }

    private final Node root;

    private PlainCaster(List<Primitive> primitives) {
        root = Node.of(primitives);
    }

    static PlainCaster of(MeshData data) {
        List<Primitive> primitives = new ArrayList<>();
        for (int triangle = 0; triangle < data.triangleCount(); triangle++) {
            primitives.add(new Triangle(
                    vertex(data, 3 * triangle), vertex(data, 3 * triangle + 1), vertex(data, 3 * triangle + 2)));
        }
        return new PlainCaster(primitives);
    }

    private static Vector3 vertex(MeshData data, int corner) {
        int i = 3 * data.triangles()[corner];
        return new Vector3(data.vertices()[i], data.vertices()[i + 1], data.vertices()[i + 2]);
    }

    static PlainCaster of(double[] spheres) {
        List<Primitive> primitives = new ArrayList<>();
        for (int i = 0; i < spheres.length; i += 4) {
            primitives.add(new Ball(new Vector3(spheres[i], spheres[i + 1], spheres[i + 2]), spheres[i + 3]));
        }
        return new PlainCaster(primitives);
    }

    PlainHit cast(double ox, double oy, double oz, double dx, double dy, double dz) {
        return root.hit(
                new PlainRay(new Vector3(ox, oy, oz), new Vector3(dx, dy, dz), new Vector3(1 / dx, 1 / dy, 1 / dz)),
                Double.POSITIVE_INFINITY);
    }
}
