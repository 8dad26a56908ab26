package org.diacaustic.preprocess;

import java.util.Optional;
import org.diacaustic.map.Chart;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Transform;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Disc;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Transformed;

/**
 * The chart that suits an object's shape: planar for what is flat, or open and more flat than round; the directions from
 * the middle of its box for everything else [Thesis 4.4].
 *
 * @param polygon the corners, if the surface is a polygon; null otherwise
 */
record SurfaceChart(Chart chart, Vector3[] polygon) {
    /** How much of an open surface's area must be left when it is added up as vectors: a hemisphere has a half. */
    private static final double FLAT_ENOUGH = 0.75;

    /** How far, of its size, a quadrilateral's corners may be off a parallelogram's: six written decimals. */
    private static final double PARALLEL = 0x1p-20;

    /**
     * Chooses the chart of an object; empty if it has no surface.
     *
     * @throws ForwardPlanException if it has no end
     */
    static Optional<SurfaceChart> of(SceneObject object) {
        Bounds bounds = object.shape().bounds();
        if (bounds.isEmpty()) {
            return Optional.empty();
        }
        if (!bounds.isFinite()) {
            throw new ForwardPlanException("'" + object.name()
                    + "' has no end and cannot have an ambient map of its own; use 'map: photon-map' instead");
        }
        return Optional.of(of(object.shape(), object.shape(), Transform.identity()));
    }

    /** The chart of a shape that has bounds and a surface. */
    static Chart of(Shape shape) {
        return of(shape, shape, Transform.identity()).chart();
    }

    private static SurfaceChart of(Shape whole, Shape part, Transform toScene) {
        if (part instanceof Transformed moved) {
            return of(whole, moved.shape(), moved.transform().then(toScene));
        }
        if (part instanceof ConvexPolygon polygon) {
            return ofPolygon(polygon, toScene);
        }
        if (part instanceof Disc disc) {
            return new SurfaceChart(ofDisc(disc, toScene), null);
        }
        Bounds bounds = whole.bounds();
        if (!whole.isClosed()) {
            SurfaceProbe probe = SurfaceProbe.of(whole);
            if (probe.vectorArea().length() > FLAT_ENOUGH * probe.area()) {
                return new SurfaceChart(along(probe.vectorArea().normalized(), bounds), null);
            }
        }
        return new SurfaceChart(Chart.spherical(bounds.centre(), Vector3.UNIT_Y, Vector3.UNIT_X), null);
    }

    private static SurfaceChart ofPolygon(ConvexPolygon polygon, Transform toScene) {
        Vector3[] corners = new Vector3[polygon.vertexCount()];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = toScene.point(polygon.vertex(i));
        }
        if (corners.length == 4) {
            Vector3 sideU = corners[1].minus(corners[0]);
            Vector3 sideV = corners[3].minus(corners[0]);
            double off = corners[2].minus(corners[1]).minus(sideV).length();
            if (off <= PARALLEL * (sideU.length() + sideV.length())) {
                return new SurfaceChart(Chart.planar(corners[0], sideU, sideV), corners);
            }
        }
        Vector3 along = corners[1].minus(corners[0]).normalized();
        Vector3 normal = vectorArea(corners).normalized();
        return new SurfaceChart(rectangle(along, normal.cross(along), corners), corners);
    }

    /** Twice the area as a vector: a fan of triangles, of which some may have none. */
    private static Vector3 vectorArea(Vector3[] corners) {
        Vector3 sum = Vector3.ZERO;
        for (int i = 1; i + 1 < corners.length; i++) {
            sum = sum.plus(corners[i].minus(corners[0]).cross(corners[i + 1].minus(corners[0])));
        }
        return sum;
    }

    /** The square around the disc, in the disc's own coordinates, brought to the scene. */
    private static Chart ofDisc(Disc disc, Transform toScene) {
        Vector3 u = disc.normal().perpendicular().times(disc.outerRadius());
        Vector3 v = disc.normal().cross(u);
        return Chart.planar(
                toScene.point(disc.centre().minus(u).minus(v)), toScene.vector(u.times(2)), toScene.vector(v.times(2)));
    }

    private static Chart along(Vector3 normal, Bounds bounds) {
        Vector3[] corners = new Vector3[8];
        for (int i = 0; i < 8; i++) {
            corners[i] = new Vector3(
                    (i & 1) == 0 ? bounds.minX() : bounds.maxX(),
                    (i & 2) == 0 ? bounds.minY() : bounds.maxY(),
                    (i & 4) == 0 ? bounds.minZ() : bounds.maxZ());
        }
        Vector3 u = normal.perpendicular();
        return rectangle(u, normal.cross(u), corners);
    }

    /** The smallest rectangle along two unit vectors, at right angles to each other, that holds all points. */
    private static Chart rectangle(Vector3 u, Vector3 v, Vector3[] points) {
        Vector3 start = points[0];
        double lowU = 0;
        double highU = 0;
        double lowV = 0;
        double highV = 0;
        for (Vector3 point : points) {
            double alongU = point.minus(start).dot(u);
            double alongV = point.minus(start).dot(v);
            lowU = Math.min(lowU, alongU);
            highU = Math.max(highU, alongU);
            lowV = Math.min(lowV, alongV);
            highV = Math.max(highV, alongV);
        }
        Vector3 origin = start.plus(u.times(lowU)).plus(v.times(lowV));
        return Chart.planar(origin, u.times(highU - lowU), v.times(highV - lowV));
    }
}
