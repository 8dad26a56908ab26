package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Vector3;

/**
 * The inverse of the bilinear map of the unit square on a convex quadrilateral [Thesis 2.4; Haines 1991]. With
 * P − p₀ = u·E + v·F + u·v·G the coordinate v is a root of a quadratic whose leading coefficient vanishes for
 * parallelograms. Where the map is one to one, the root that is wanted is the one at which the quadratic rises; taken in
 * the form that adds and never subtracts, it needs no case for parallelograms and keeps all digits near them.
 */
final class QuadrilateralMapping implements InverseMapping {
    private final Vector3 corner;
    private final Vector3 e;
    private final Vector3 f;
    private final Vector3 g;
    private final int first;
    private final int second;
    private final double crossEF;
    private final double crossGF;

    /**
     * @param corners at (0, 0), (1, 0), (1, 1) and (0, 1)
     * @param normal of the plane, for which the corners go anticlockwise
     */
    QuadrilateralMapping(Vector3[] corners, Vector3 normal) {
        this.corner = corners[0];
        this.e = corners[1].minus(corners[0]);
        this.f = corners[3].minus(corners[0]);
        this.g = corners[2].minus(corners[3]).minus(e);
        double ax = Math.abs(normal.x());
        double ay = Math.abs(normal.y());
        double az = Math.abs(normal.z());
        int dropped = az >= ax && az >= ay ? 2 : ay >= ax ? 1 : 0;
        // Seen along the dropped axis the corners still go anticlockwise.
        boolean positive = normal.component(dropped) > 0;
        this.first = (dropped + (positive ? 1 : 2)) % 3;
        this.second = (dropped + (positive ? 2 : 1)) % 3;
        this.crossEF = cross(e, f);
        this.crossGF = cross(g, f);
    }

    private double cross(Vector3 a, Vector3 b) {
        return Arithmetic.differenceOfProducts(
                a.component(first), b.component(second), a.component(second), b.component(first));
    }

    @Override
    public void map(Hit hit) {
        double hx = hit.x - corner.x();
        double hy = hit.y - corner.y();
        double hz = hit.z - corner.z();
        double h1 = first == 0 ? hx : first == 1 ? hy : hz;
        double h2 = second == 0 ? hx : second == 1 ? hy : hz;
        double crossHG = Arithmetic.differenceOfProducts(h1, g.component(second), h2, g.component(first));
        double crossHE = Arithmetic.differenceOfProducts(h1, e.component(second), h2, e.component(first));
        double v = PlanarMapping.within(risingRoot(crossGF, crossEF + crossHG, crossHE));
        double sideX = Math.fma(v, g.x(), e.x());
        double sideY = Math.fma(v, g.y(), e.y());
        double sideZ = Math.fma(v, g.z(), e.z());
        double along =
                Math.fma(-v, f.x(), hx) * sideX + Math.fma(-v, f.y(), hy) * sideY + Math.fma(-v, f.z(), hz) * sideZ;
        double u = PlanarMapping.within(along / (sideX * sideX + sideY * sideY + sideZ * sideZ));
        hit.setMap(u, v);
        hit.setTangents(
                sideX, sideY, sideZ, Math.fma(u, g.x(), f.x()), Math.fma(u, g.y(), f.y()), Math.fma(u, g.z(), f.z()));
    }

    /** The root of a·v² + b·v + c at which the quadratic rises; its slope there is the root of the discriminant. */
    private static double risingRoot(double a, double b, double c) {
        double discriminant = Arithmetic.differenceOfProducts(b, b, 4 * a, c);
        double slope = Math.sqrt(Math.max(0, discriminant));
        return b > 0 ? -2 * c / (b + slope) : (slope - b) / (2 * a);
    }
}
