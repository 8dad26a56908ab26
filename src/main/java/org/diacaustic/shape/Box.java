package org.diacaustic.shape;

import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/**
 * A solid box along the axes. Its primitives are its faces −x, +x, −y, +y, −z, +z, numbered from 0, and its edges
 * belong to it: a line meets it in one piece or not at all, so a ray that enters always leaves.
 *
 * <p>Its map holds the faces side by side without overlap: the column is the axis of the face's normal, the lower row
 * the face at the smaller coordinate. Within a face, seen from outside, u runs to the right and v up, where up is y, or
 * away from the viewer who looks at the top.
 */
public final class Box implements Shape {
    private final Bounds bounds;
    private final double[] corners;

    /**
     * @param low the corner of the smallest coordinates
     * @param high the corner of the largest; each must be larger, and finite
     * @throws IllegalArgumentException otherwise
     */
    public Box(Vector3 low, Vector3 high) {
        if (!(low.isFinite() && high.isFinite() && low.x() < high.x() && low.y() < high.y() && low.z() < high.z())) {
            throw new IllegalArgumentException(
                    "a box must be finite and have a volume, but goes from " + low + " to " + high);
        }
        this.bounds = Bounds.of(low, high);
        this.corners = new double[] {low.x(), high.x(), low.y(), high.y(), low.z(), high.z()};
    }

    @Override
    public Bounds bounds() {
        return bounds;
    }

    @Override
    public boolean intersect(Ray ray) {
        ray.tests++;
        double entry = Double.NEGATIVE_INFINITY;
        double exit = Double.POSITIVE_INFINITY;
        int entryFace = 0;
        int exitFace = 0;
        for (int axis = 0; axis < 3; axis++) {
            double origin = axis == 0 ? ray.originX : axis == 1 ? ray.originY : ray.originZ;
            double direction = axis == 0 ? ray.directionX : axis == 1 ? ray.directionY : ray.directionZ;
            int nearFace = direction > 0 ? 2 * axis : 2 * axis + 1;
            int farFace = nearFace ^ 1;
            if (direction == 0) {
                if (origin < corners[2 * axis] || origin > corners[2 * axis + 1]) {
                    return false;
                }
                continue;
            }
            double near = (corners[nearFace] - origin) / direction;
            double far = (corners[farFace] - origin) / direction;
            if (near > entry) {
                entry = near;
                entryFace = nearFace;
            }
            if (far < exit) {
                exit = far;
                exitFace = farFace;
            }
        }
        if (ray.leaving != Ray.FREE) {
            // Inward from a face there is always a way out, be it shorter than rounding.
            return goesInward(ray) && accept(ray, Math.max(exit, Double.MIN_VALUE), exitFace);
        }
        // A box thinner than the rounding of distances is met and left at once, but through two faces that lie
        // opposite.
        boolean isMet = entry < exit || (entry == exit && (entryFace ^ exitFace) == 1);
        return isMet && (entry > 0 ? accept(ray, entry, entryFace) : accept(ray, exit, exitFace));
    }

    private static boolean goesInward(Ray ray) {
        double direction = switch (ray.leaving >> 1) {
            case 0 -> ray.directionX;
            case 1 -> ray.directionY;
            default -> ray.directionZ;
        };
        return (ray.leaving & 1) == 0 ? direction > 0 : direction < 0;
    }

    private static boolean accept(Ray ray, double t, int face) {
        if (t > 0 && t < ray.tMax) {
            ray.hit(t, face);
            return true;
        }
        return false;
    }

    /** The point is exactly on its face and within it, so its error is 0. */
    @Override
    public void complete(Ray ray, Hit hit) {
        int face = hit.primitive;
        int axis = face >> 1;
        double side = corners[face];
        hit.setPoint(
                axis == 0 ? side : within(0, ray.pointX(hit.t)),
                axis == 1 ? side : within(1, ray.pointY(hit.t)),
                axis == 2 ? side : within(2, ray.pointZ(hit.t)),
                0);
        double sign = (face & 1) == 0 ? -1 : 1;
        hit.setNormal(axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0);
    }

    private double within(int axis, double coordinate) {
        return Math.max(corners[2 * axis], Math.min(corners[2 * axis + 1], coordinate));
    }

    @Override
    public void inverseMap(Hit hit) {
        double x = fraction(0, hit.x);
        double y = fraction(1, hit.y);
        double z = fraction(2, hit.z);
        double width = 3 * (corners[1] - corners[0]);
        double height = 2 * (corners[3] - corners[2]);
        double depth = corners[5] - corners[4];
        switch (hit.primitive) {
            case 0 -> cell(hit, z, y, 0, 0, 3 * depth, 0, height, 0);
            case 1 -> cell(hit, 1 - z, y, 0, 0, -3 * depth, 0, height, 0);
            case 2 -> cell(hit, x, z, width, 0, 0, 0, 0, 2 * depth);
            case 3 -> cell(hit, x, 1 - z, width, 0, 0, 0, 0, -2 * depth);
            case 4 -> cell(hit, 1 - x, y, -width, 0, 0, 0, height, 0);
            default -> cell(hit, x, y, width, 0, 0, 0, height, 0);
        }
    }

    private double fraction(int axis, double coordinate) {
        double low = corners[2 * axis];
        return PlanarMapping.within((coordinate - low) / (corners[2 * axis + 1] - low));
    }

    private static void cell(
            Hit hit, double u, double v, double ux, double uy, double uz, double vx, double vy, double vz) {
        hit.setMap(((hit.primitive >> 1) + u) / 3, ((hit.primitive & 1) + v) / 2);
        hit.setTangents(ux, uy, uz, vx, vy, vz);
    }

    @Override
    public boolean isClosed() {
        return true;
    }
}
