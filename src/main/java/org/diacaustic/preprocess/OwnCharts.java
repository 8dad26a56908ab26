package org.diacaustic.preprocess;

import java.util.Optional;
import org.diacaustic.light.Light;
import org.diacaustic.light.LightPoint;
import org.diacaustic.map.Chart;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Transform;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Disc;
import org.diacaustic.shape.Ellipsoid;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.diacaustic.shape.Transformed;

/** Charts of light rays that fit an object: the disc that a ball is seen as, and the parallelogram of a flat surface. */
final class OwnCharts {
    /** How far inside its border the chart of a flat surface ends, of its size: rays at the very border miss by rounding. */
    private static final double BORDER = 0x1p-30;

    private OwnCharts() {}

    /** The chart of the only object that the beam is aimed at; empty if there are several, or it has none. */
    static Optional<EmissionChart> of(Beam beam, LightPoint from) {
        int[] objects = beam.specularObjects().toArray();
        boolean isOne = objects.length == 1 && beam.window().objects().cardinality() == 1;
        return isOne ? of(beam, from, beam.scene().object(objects[0]).shape()) : Optional.empty();
    }

    private static Optional<EmissionChart> of(Beam beam, LightPoint from, Shape whole) {
        Shape shape = whole;
        Transform toScene = Transform.identity();
        while (shape instanceof Transformed moved) {
            toScene = moved.transform().then(toScene);
            shape = moved.shape();
        }
        boolean isParallel = beam.light().spread() == Light.Spread.PARALLEL;
        if (shape instanceof ConvexPolygon || shape instanceof Disc) {
            return flat(beam, from, SurfaceChart.of(whole), isParallel);
        }
        if (isParallel) {
            return Optional.empty();
        }
        if (shape instanceof Sphere sphere) {
            Vector3 c = sphere.centre();
            return BallChart.of(
                    from,
                    Transform.identity().scale(sphere.radius()).translate(c).then(toScene));
        }
        if (shape instanceof Ellipsoid ball) {
            Vector3 r = ball.radii();
            Transform local = Transform.identity().scale(r.x(), r.y(), r.z()).translate(ball.centre());
            return BallChart.of(from, local.then(toScene));
        }
        return Optional.empty();
    }

    private static Optional<EmissionChart> flat(Beam beam, LightPoint from, Chart chart, boolean isParallel) {
        Vector3 corner = point(chart, BORDER, BORDER);
        Vector3 sideU = point(chart, 1 - BORDER, BORDER).minus(corner);
        Vector3 sideV = point(chart, BORDER, 1 - BORDER).minus(corner);
        if (isParallel) {
            Vector3 d = new Vector3(from.normalX, from.normalY, from.normalZ);
            return Optional.of(new ParallelChart(
                    d, corner.minus(d.times(beam.startDistance())), across(sideU, d), across(sideV, d)));
        }
        Vector3 towards = corner.minus(new Vector3(from.x, from.y, from.z));
        double height = Math.abs(towards.dot(sideU.cross(sideV).normalized()));
        // In its own plane a light sees nothing of it.
        return height > 0 ? Optional.of(new PlaneChart(from, towards, sideU, sideV)) : Optional.empty();
    }

    private static Vector3 point(Chart chart, double u, double v) {
        Ray line = new Ray();
        chart.aim(u, v, line);
        return new Vector3(line.originX, line.originY, line.originZ);
    }

    private static Vector3 across(Vector3 side, Vector3 direction) {
        return side.minus(direction.times(side.dot(direction)));
    }
}
