package org.diacaustic.shape;

import org.diacaustic.math.Vector3;

/**
 * The cylindrical inverse mapping [Thesis 2.4]: u runs once around an axis, v along it; v repeats beyond the axis.
 * Points are projected straight away from the axis.
 */
public final class CylindricalMapping implements InverseMapping {
    private final AxisFrame frame;
    private final double length;

    /**
     * @param base where v = 0
     * @param axis from there to v = 1, in scene units
     * @throws IllegalArgumentException if the axis is zero or something is not finite
     */
    public CylindricalMapping(Vector3 base, Vector3 axis) {
        if (!base.isFinite()) {
            throw new IllegalArgumentException("base of a cylindrical mapping must be finite, but is " + base);
        }
        this.frame = new AxisFrame(base, axis);
        this.length = axis.length();
    }

    @Override
    public void map(Hit hit) {
        double x = hit.x - frame.origin.x();
        double y = hit.y - frame.origin.y();
        double z = hit.z - frame.origin.z();
        double a = frame.acrossOf(x, y, z);
        double b = frame.asideOf(x, y, z);
        hit.setMap(AxisFrame.turn(a, b), PlanarMapping.repeated(frame.upOf(x, y, z) / length));
        double turn = 2 * Math.PI;
        frame.setTangents(hit, -turn * b, turn * a, 0, 0, 0, length);
        Projection.ofTangents(
                hit,
                a * frame.across.x() + b * frame.aside.x(),
                a * frame.across.y() + b * frame.aside.y(),
                a * frame.across.z() + b * frame.aside.z());
    }
}
