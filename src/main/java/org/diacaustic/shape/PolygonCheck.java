package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Vector3;

/** Finds the plane of a polygon, and refuses one that is not flat, not convex or without area. */
final class PolygonCheck {
    /** What six written decimals leave of flatness, as a fraction of the polygon's extent. */
    private static final double FLATNESS = 0x1p-20;

    private final Vector3[] vertices;
    private final double extent;
    private final double rounding;
    private final Vector3 normal;
    private final double deviation;

    PolygonCheck(Vector3[] vertices) {
        this.vertices = vertices;
        if (vertices.length < 3) {
            throw new IllegalArgumentException("a polygon needs at least 3 vertices, but has " + vertices.length);
        }
        requireDistinctFinite();
        this.extent = extent();
        this.rounding = Arithmetic.gamma(16) * largestCoordinate();
        this.normal = normalOfArea();
        this.deviation = requireFlat();
        requireConvex();
    }

    /** The unit normal by the right-hand rule. */
    Vector3 normal() {
        return normal;
    }

    /** How far the vertices may lie off the plane through vertex 0, in scene units. */
    double deviation() {
        return deviation;
    }

    private void requireDistinctFinite() {
        for (int i = 0; i < vertices.length; i++) {
            if (!vertices[i].isFinite()) {
                throw new IllegalArgumentException(named(i) + " of the polygon must be finite");
            }
            for (int k = 0; k < i; k++) {
                if (vertices[i].equals(vertices[k])) {
                    throw new IllegalArgumentException(named(i) + " of the polygon repeats vertex " + k);
                }
            }
        }
    }

    private double extent() {
        double largest = 0;
        for (Vector3 vertex : vertices) {
            largest = Math.max(largest, vertex.minus(vertices[0]).length());
        }
        return largest;
    }

    private double largestCoordinate() {
        double largest = 0;
        for (Vector3 v : vertices) {
            largest = Math.max(largest, Math.max(Math.abs(v.x()), Math.max(Math.abs(v.y()), Math.abs(v.z()))));
        }
        return largest;
    }

    /** Twice the area as a vector is the sum of a fan of triangles, convex or not [Newell 1972]. */
    private Vector3 normalOfArea() {
        Vector3 sum = Vector3.ZERO;
        for (int i = 1; i + 1 < vertices.length; i++) {
            sum = sum.plus(vertices[i].minus(vertices[0]).cross(vertices[i + 1].minus(vertices[0])));
        }
        if (!(sum.length() > rounding * extent)) {
            throw new IllegalArgumentException(
                    "the polygon has no area: its vertices lie on a line or its edges cross, from " + named(0) + " on");
        }
        return sum.normalized();
    }

    private double requireFlat() {
        double largest = 0;
        double sum = 0;
        for (Vector3 vertex : vertices) {
            largest = Math.max(largest, Math.abs(height(vertex)));
            sum += height(vertex);
        }
        if (largest > FLATNESS * extent + rounding) {
            double mean = sum / vertices.length;
            int farthest = 0;
            for (int i = 1; i < vertices.length; i++) {
                if (Math.abs(height(vertices[i]) - mean) >= Math.abs(height(vertices[farthest]) - mean)) {
                    farthest = i;
                }
            }
            throw new IllegalArgumentException("the polygon must be flat, but " + named(farthest) + " lies "
                    + Math.abs(height(vertices[farthest]) - mean) + " off the plane through the middle of all");
        }
        return largest;
    }

    /** Over the plane through vertex 0. */
    private double height(Vector3 vertex) {
        return vertex.minus(vertices[0]).dot(normal);
    }

    private void requireConvex() {
        int count = vertices.length;
        for (int i = 0; i < count; i++) {
            Vector3 before = vertices[i].minus(vertices[(i + count - 1) % count]);
            Vector3 after = vertices[(i + 1) % count].minus(vertices[i]);
            double turn = before.cross(after).dot(normal);
            boolean turnsBack = before.dot(after) < 0 && turn <= rounding * before.length();
            if (turnsBack || turn < -rounding * Math.max(before.length(), after.length())) {
                throw new IllegalArgumentException("the polygon must be convex, but turns inward at " + named(i));
            }
        }
        for (int i = 0; i < count; i++) {
            Vector3 edge = vertices[(i + 1) % count].minus(vertices[i]);
            for (int k = 0; k < count; k++) {
                if (edge.cross(vertices[k].minus(vertices[i])).dot(normal) < -rounding * edge.length()) {
                    throw new IllegalArgumentException("the polygon must not cross itself, but " + named(k)
                            + " lies outside the edge from vertex " + i + " to vertex " + (i + 1) % count);
                }
            }
        }
    }

    private String named(int index) {
        return "vertex " + index + " (counted from 0) at " + vertices[index];
    }
}
