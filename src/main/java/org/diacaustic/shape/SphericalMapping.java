package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Vector3;

/**
 * The spherical inverse mapping of the thesis [Thesis 2.4, Eq. 4; Haines 1991]: v = 0 at the south pole, 1 at the north;
 * u runs once around, from the equator vector towards pole × equator. Eq. 4 takes arc cosines of quotients that lose
 * half their digits near the seam and are 0/0 at the poles; the same angles come here from arc tangents, which do not.
 */
public final class SphericalMapping implements InverseMapping {
    /** Pole along +y, equator along +x. */
    public static final SphericalMapping UPRIGHT = new SphericalMapping(Vector3.ZERO, Vector3.UNIT_Y, Vector3.UNIT_X);

    private final Vector3 centre;
    private final Vector3 pole;
    private final Vector3 equator;
    private final Vector3 third;

    /**
     * @param centre the point from which the directions to the surface are taken
     * @param pole the direction of v = 1
     * @param equator the direction of u = 0; its part along the pole is left out
     * @throws IllegalArgumentException if pole and equator are parallel, zero or not finite
     */
    public SphericalMapping(Vector3 centre, Vector3 pole, Vector3 equator) {
        this.centre = centre;
        this.pole = pole.normalized();
        Vector3 e = equator.normalized();
        this.third = this.pole.cross(e).normalized();
        this.equator = this.third.cross(this.pole);
    }

    @Override
    public void map(Hit hit) {
        double x = hit.x - centre.x();
        double y = hit.y - centre.y();
        double z = hit.z - centre.z();
        map(x, y, z, hit);
        tangents(x, y, z, hit);
        Projection.ofTangents(hit, x, y, z);
    }

    /** Sets u and v of the direction (x, y, z), of any length. */
    void map(double x, double y, double z, Hit hit) {
        double alongPole = x * pole.x() + y * pole.y() + z * pole.z();
        double alongEquator = x * equator.x() + y * equator.y() + z * equator.z();
        double alongThird = x * third.x() + y * third.y() + z * third.z();
        double fromAxis = Arithmetic.length(alongEquator, alongThird, 0);
        double v = StrictMath.atan2(fromAxis, -alongPole) / Math.PI;
        hit.setMap(AxisFrame.turn(alongEquator, alongThird), v);
    }

    /** Sets the tangents of the point at (x, y, z) from the centre: around the pole, and towards it. */
    void tangents(double x, double y, double z, Hit hit) {
        double alongPole = x * pole.x() + y * pole.y() + z * pole.z();
        double ex = x - alongPole * pole.x();
        double ey = y - alongPole * pole.y();
        double ez = z - alongPole * pole.z();
        double fromAxis = Arithmetic.length(ex, ey, ez);
        double turn = 2 * Math.PI;
        double climb = fromAxis == 0 ? 0 : -Math.PI * alongPole / fromAxis;
        double lift = Math.PI * fromAxis;
        hit.setTangents(
                turn * (pole.y() * ez - pole.z() * ey),
                turn * (pole.z() * ex - pole.x() * ez),
                turn * (pole.x() * ey - pole.y() * ex),
                climb * ex + lift * pole.x(),
                climb * ey + lift * pole.y(),
                climb * ez + lift * pole.z());
    }
}
