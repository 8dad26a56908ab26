package org.diacaustic.map;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/**
 * See {@link Chart#spherical}. Eq. 4 of the thesis takes arc cosines of quotients that lose half their digits near the
 * seam and are 0/0 at the poles; the same angles come here from arc tangents, which do not.
 */
final class SphericalChart implements Chart {
    private final Vector3 centre;
    private final Vector3 pole;
    private final Vector3 equator;
    private final Vector3 third;

    SphericalChart(Vector3 centre, Vector3 pole, Vector3 equator) {
        if (!centre.isFinite()) {
            throw new IllegalArgumentException("centre of a spherical chart must be finite, but is " + centre);
        }
        this.centre = centre;
        this.pole = pole.normalized();
        this.third = this.pole.cross(equator.normalized()).normalized();
        this.equator = third.cross(this.pole);
    }

    @Override
    public double u(double x, double y, double z) {
        double alongEquator = along(equator, x, y, z);
        double alongThird = along(third, x, y, z);
        if (alongEquator == 0 && alongThird == 0) {
            return 0;
        }
        double turn = StrictMath.atan2(alongThird, alongEquator) / (2 * Math.PI);
        return turn < 0 ? turn + 1 : turn;
    }

    @Override
    public double v(double x, double y, double z) {
        double fromAxis = Arithmetic.length(along(equator, x, y, z), along(third, x, y, z), 0);
        return StrictMath.atan2(fromAxis, -along(pole, x, y, z)) / Math.PI;
    }

    private double along(Vector3 axis, double x, double y, double z) {
        return (x - centre.x()) * axis.x() + (y - centre.y()) * axis.y() + (z - centre.z()) * axis.z();
    }

    @Override
    public boolean goesAround() {
        return true;
    }

    @Override
    public void aim(double u, double v, Ray ray) {
        double longitude = 2 * Math.PI * u;
        double fromSouth = Math.PI * v;
        double sine = StrictMath.sin(fromSouth);
        double e = sine * StrictMath.cos(longitude);
        double t = sine * StrictMath.sin(longitude);
        double p = -StrictMath.cos(fromSouth);
        ray.set(
                centre.x(),
                centre.y(),
                centre.z(),
                e * equator.x() + t * third.x() + p * pole.x(),
                e * equator.y() + t * third.y() + p * pole.y(),
                e * equator.z() + t * third.z() + p * pole.z());
    }

    /** A zone of the unit sphere has the area 2π × its height: the difference of two cosines, without cancellation. */
    @Override
    public double spread(double width, double lowV, double highV) {
        double height = 2 * StrictMath.sin(Math.PI / 2 * (highV + lowV)) * StrictMath.sin(Math.PI / 2 * (highV - lowV));
        return 2 * Math.PI * width * height;
    }

    @Override
    public double sectionPerSpread(double x, double y, double z) {
        double dx = x - centre.x();
        double dy = y - centre.y();
        double dz = z - centre.z();
        return dx * dx + dy * dy + dz * dz;
    }
}
