package org.diacaustic.map;

import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/** See {@link Chart#planar}. */
final class PlanarChart implements Chart {
    private final Vector3 origin;
    private final Vector3 sideU;
    private final Vector3 sideV;
    private final Vector3 dualU;
    private final Vector3 dualV;
    private final Vector3 normal;
    private final double area;

    PlanarChart(Vector3 origin, Vector3 sideU, Vector3 sideV) {
        if (!origin.isFinite()) {
            throw new IllegalArgumentException("origin of a planar chart must be finite, but is " + origin);
        }
        Vector3 unitU = sideU.normalized();
        Vector3 unitV = sideV.normalized();
        Vector3 cross = unitU.cross(unitV);
        double sine = cross.length();
        if (sine == 0) {
            throw new IllegalArgumentException(
                    "sides of a planar chart must not be parallel, but are " + sideU + " and " + sideV);
        }
        this.origin = origin;
        this.sideU = sideU;
        this.sideV = sideV;
        this.normal = cross.normalized();
        this.dualU = unitV.cross(normal).times(1 / (sine * sideU.length()));
        this.dualV = normal.cross(unitU).times(1 / (sine * sideV.length()));
        this.area = sine * sideU.length() * sideV.length();
    }

    @Override
    public double u(double x, double y, double z) {
        return along(dualU, x, y, z);
    }

    @Override
    public double v(double x, double y, double z) {
        return along(dualV, x, y, z);
    }

    private double along(Vector3 dual, double x, double y, double z) {
        return (x - origin.x()) * dual.x() + (y - origin.y()) * dual.y() + (z - origin.z()) * dual.z();
    }

    @Override
    public boolean goesAround() {
        return false;
    }

    @Override
    public void aim(double u, double v, Ray ray) {
        ray.set(
                Math.fma(v, sideV.x(), Math.fma(u, sideU.x(), origin.x())),
                Math.fma(v, sideV.y(), Math.fma(u, sideU.y(), origin.y())),
                Math.fma(v, sideV.z(), Math.fma(u, sideU.z(), origin.z())),
                normal.x(),
                normal.y(),
                normal.z());
    }

    @Override
    public double spread(double width, double lowV, double highV) {
        return width * (highV - lowV) * area;
    }

    @Override
    public double sectionPerSpread(double x, double y, double z) {
        return 1;
    }
}
