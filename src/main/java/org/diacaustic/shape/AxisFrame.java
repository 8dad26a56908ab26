package org.diacaustic.shape;

import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/** Right-handed coordinates about an axis: across, aside and up along it. For solids of revolution. */
final class AxisFrame {
    final Vector3 origin;
    final Vector3 across;
    final Vector3 aside;
    final Vector3 up;

    /** The direction across is any, but x for an axis along y and for one along z. */
    AxisFrame(Vector3 origin, Vector3 axis) {
        this.origin = origin;
        this.up = axis.normalized();
        Vector3 reference = Math.abs(up.x()) < 0.8 ? Vector3.UNIT_X : Vector3.UNIT_Y;
        this.aside = up.cross(reference).normalized();
        this.across = aside.cross(up);
    }

    double acrossOf(double x, double y, double z) {
        return dot(across, x, y, z);
    }

    double asideOf(double x, double y, double z) {
        return dot(aside, x, y, z);
    }

    double upOf(double x, double y, double z) {
        return dot(up, x, y, z);
    }

    private static double dot(Vector3 axis, double x, double y, double z) {
        return x * axis.x() + y * axis.y() + z * axis.z();
    }

    double originX(Ray ray) {
        return ray.originX - origin.x();
    }

    double originY(Ray ray) {
        return ray.originY - origin.y();
    }

    double originZ(Ray ray) {
        return ray.originZ - origin.z();
    }

    /** Sets the point of the hit from coordinates of this frame. */
    void setPoint(Hit hit, double a, double b, double c, double error) {
        hit.setPoint(
                a * across.x() + b * aside.x() + c * up.x() + origin.x(),
                a * across.y() + b * aside.y() + c * up.y() + origin.y(),
                a * across.z() + b * aside.z() + c * up.z() + origin.z(),
                error);
    }

    /** Sets the normal of the hit, to length 1, from coordinates of this frame. */
    void setNormal(Hit hit, double a, double b, double c) {
        double x = a * across.x() + b * aside.x() + c * up.x();
        double y = a * across.y() + b * aside.y() + c * up.y();
        double z = a * across.z() + b * aside.z() + c * up.z();
        double length = Math.sqrt(x * x + y * y + z * z);
        hit.setNormal(x / length, y / length, z / length);
    }

    /** Sets the tangents of the hit from coordinates of this frame. */
    void setTangents(Hit hit, double ua, double ub, double uc, double va, double vb, double vc) {
        hit.setTangents(
                ua * across.x() + ub * aside.x() + uc * up.x(),
                ua * across.y() + ub * aside.y() + uc * up.y(),
                ua * across.z() + ub * aside.z() + uc * up.z(),
                va * across.x() + vb * aside.x() + vc * up.x(),
                va * across.y() + vb * aside.y() + vc * up.y(),
                va * across.z() + vb * aside.z() + vc * up.z());
    }

    /** The turn of (a, b) from across towards aside, in 0..1; 0 on the axis. */
    static double turn(double a, double b) {
        if (a == 0 && b == 0) {
            return 0;
        }
        double turn = StrictMath.atan2(b, a) / (2 * Math.PI);
        return turn < 0 ? turn + 1 : turn;
    }

    /** The largest coordinate of a point, without sign. */
    static double largest(Vector3 p) {
        return Math.max(Math.abs(p.x()), Math.max(Math.abs(p.y()), Math.abs(p.z())));
    }

    /** The box of a disc with a unit normal, widened by a margin. */
    static Bounds discBounds(Vector3 centre, Vector3 normal, double radius, double margin) {
        return Bounds.around(
                centre,
                Math.fma(radius, Math.sqrt(normal.y() * normal.y() + normal.z() * normal.z()), margin),
                Math.fma(radius, Math.sqrt(normal.z() * normal.z() + normal.x() * normal.x()), margin),
                Math.fma(radius, Math.sqrt(normal.x() * normal.x() + normal.y() * normal.y()), margin));
    }
}
