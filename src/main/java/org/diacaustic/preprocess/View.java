package org.diacaustic.preprocess;

import org.diacaustic.light.LightPoint;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Vector3;

/**
 * How a light point sees a window: the frame that looks at its middle, and how far it reaches to each side. Where the point
 * lies in the bounds of the window, or so near that they reach round it, it sees the window in all directions.
 */
final class View {
    final Vector3 axis;
    final Vector3 u;
    final Vector3 v;

    /** Whether everything lies in front, so that {@link #minU} and the rest are set: tangents of angles to the axis. */
    final boolean isInFront;

    double minU = Double.POSITIVE_INFINITY;
    double maxU = Double.NEGATIVE_INFINITY;
    double minV = Double.POSITIVE_INFINITY;
    double maxV = Double.NEGATIVE_INFINITY;

    /** 1 − cos of the half-angle of a cone about the axis that holds the window; 2 for all directions. */
    final double versine;

    View(LightPoint from, EmissionWindow window) {
        Bounds bounds = window.bounds();
        Vector3 point = new Vector3(from.x, from.y, from.z);
        Vector3 towards = bounds.isFinite() ? bounds.centre().minus(point) : Vector3.ZERO;
        boolean isOutside = bounds.isFinite() && !bounds.contains(from.x, from.y, from.z) && towards.length() > 0;
        axis = isOutside ? towards.normalized() : Vector3.UNIT_Z;
        u = uprightAcross(axis);
        v = axis.cross(u);
        boolean inFront = isOutside;
        double largest = 0;
        if (isOutside) {
            for (Vector3 corner : window.corners()) {
                Vector3 to = corner.minus(point);
                double depth = to.dot(axis);
                inFront &= depth > 0;
                include(to.dot(u) / depth, to.dot(v) / depth);
                largest = Math.max(largest, versine(to, depth));
            }
        }
        isInFront = inFront;
        versine = inFront ? largest : 2;
    }

    /** Without the cancellation of 1 − cos for narrow cones. */
    private double versine(Vector3 to, double depth) {
        double across = to.dot(u) * to.dot(u) + to.dot(v) * to.dot(v);
        double distance = Math.sqrt(across + depth * depth);
        return across / (distance * (distance + depth));
    }

    private void include(double tangentU, double tangentV) {
        minU = Math.min(minU, tangentU);
        maxU = Math.max(maxU, tangentU);
        minV = Math.min(minV, tangentV);
        maxV = Math.max(maxV, tangentV);
    }

    /** A unit vector across the axis that keeps as much as it can of a coordinate axis: scenes are built along those. */
    static Vector3 uprightAcross(Vector3 axis) {
        Vector3 straight = Math.abs(axis.x()) <= Math.abs(axis.z()) ? Vector3.UNIT_X : Vector3.UNIT_Z;
        return straight.minus(axis.times(axis.dot(straight))).normalized();
    }
}
