package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Matrix;
import org.diacaustic.math.Vector3;

/** The box of a quadric p·Qp + 2·l·p + j = 0, which only an ellipsoid has. */
final class QuadricBounds {
    private QuadricBounds() {}

    /** Whether −Q has only positive leading minors [Sylvester]. */
    static boolean isNegativeDefinite(Matrix q) {
        return isPositiveDefinite(q.times(Matrix.diagonal(-1, -1, -1)));
    }

    private static boolean isPositiveDefinite(Matrix q) {
        Vector3 x = new Vector3(q.xx(), q.yx(), q.zx());
        Vector3 y = new Vector3(q.xy(), q.yy(), q.zy());
        Vector3 z = new Vector3(q.xz(), q.yz(), q.zz());
        return q.xx() > 0
                && Arithmetic.differenceOfProducts(q.xx(), q.yy(), q.xy(), q.xy()) > 0
                && x.dot(y.cross(z)) > Arithmetic.gamma(8) * x.length() * y.length() * z.length();
    }

    /**
     * The box of an ellipsoid, widened by the rounding of its own computation; all of space for anything else, and for an
     * ellipsoid so long that rounding could make it a paraboloid.
     *
     * @throws IllegalArgumentException if the left side is positive everywhere
     */
    static Bounds of(Matrix q, Vector3 l, double j) {
        if (!isPositiveDefinite(q)) {
            return Bounds.UNBOUNDED;
        }
        Matrix inverse = q.inverse();
        double rounding = Arithmetic.gamma(64) * q.norm() * inverse.norm();
        if (rounding > 0x1p-10) {
            return Bounds.UNBOUNDED;
        }
        Vector3 centre = inverse.times(l).negated();
        double level = -(l.dot(centre) + j);
        double levelSize = Math.abs(l.dot(centre)) + Math.abs(j);
        if (!(level > 0)) {
            throw new IllegalArgumentException("a quadric must have points, but its equation has no solution");
        }
        double reach = (level + rounding * levelSize) * (1 + rounding);
        double margin = rounding * centre.length();
        return Bounds.around(
                centre,
                Math.sqrt(reach * inverse.xx()) * (1 + rounding) + margin,
                Math.sqrt(reach * inverse.yy()) * (1 + rounding) + margin,
                Math.sqrt(reach * inverse.zz()) * (1 + rounding) + margin);
    }
}
