package org.diacaustic.preprocess;

import org.diacaustic.light.LightPoint;
import org.diacaustic.math.Vector3;

/** The rays from a light point through a parallelogram. Steps on it are not alike in solid angle; the measure says so. */
final class PlaneChart extends EmissionChart {
    private final Vector3 from;
    private final Vector3 corner;
    private final Vector3 sideU;
    private final Vector3 sideV;
    private final double volume;

    /**
     * @param corner from the light point to the corner at p = q = 0
     * @param sideU from that corner to p = 1
     * @param sideV from that corner to q = 1
     */
    PlaneChart(LightPoint from, Vector3 corner, Vector3 sideU, Vector3 sideV) {
        this.from = new Vector3(from.x, from.y, from.z);
        this.corner = corner;
        this.sideU = sideU;
        this.sideV = sideV;
        this.volume = Math.abs(corner.dot(sideU.cross(sideV)));
    }

    /** The solid angle is dA · cosθ ÷ r², where dA · cosθ · r is the volume over the parallelogram, the same everywhere. */
    @Override
    public void aim(double p, double q, LightRay ray) {
        double x = corner.x() + p * sideU.x() + q * sideV.x();
        double y = corner.y() + p * sideU.y() + q * sideV.y();
        double z = corner.z() + p * sideU.z() + q * sideV.z();
        ray.setOrigin(from.x(), from.y(), from.z());
        ray.setDirection(x, y, z);
        ray.measure = density(x, y, z);
    }

    @Override
    public double density(double p, double q) {
        return density(
                corner.x() + p * sideU.x() + q * sideV.x(),
                corner.y() + p * sideU.y() + q * sideV.y(),
                corner.z() + p * sideU.z() + q * sideV.z());
    }

    private double density(double x, double y, double z) {
        double distanceSquared = x * x + y * y + z * z;
        return volume / (distanceSquared * Math.sqrt(distanceSquared));
    }

    @Override
    public double width() {
        return sideU.length();
    }

    @Override
    public double height() {
        return sideV.length();
    }
}
