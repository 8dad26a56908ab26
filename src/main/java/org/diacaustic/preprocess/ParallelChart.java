package org.diacaustic.preprocess;

import org.diacaustic.math.Vector3;

/** Parallel rays through a rectangle across them. */
final class ParallelChart extends EmissionChart {
    private final Vector3 direction;
    private final Vector3 corner;
    private final Vector3 sideU;
    private final Vector3 sideV;
    private final double area;

    ParallelChart(Vector3 direction, Vector3 corner, Vector3 sideU, Vector3 sideV) {
        this.direction = direction;
        this.corner = corner;
        this.sideU = sideU;
        this.sideV = sideV;
        this.area = sideU.cross(sideV).length();
    }

    @Override
    public void aim(double p, double q, LightRay ray) {
        ray.setOrigin(
                corner.x() + p * sideU.x() + q * sideV.x(),
                corner.y() + p * sideU.y() + q * sideV.y(),
                corner.z() + p * sideU.z() + q * sideV.z());
        ray.directionX = direction.x();
        ray.directionY = direction.y();
        ray.directionZ = direction.z();
        ray.measure = area;
    }

    @Override
    public double density(double p, double q) {
        return area;
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
