package org.diacaustic.shape;

import org.diacaustic.math.Vector3;

/**
 * The planar inverse mapping [Thesis 2.4; Haines 1991]: a parallelogram of the plane is the map, and the map repeats
 * beyond it. Points off the plane are projected along its normal.
 */
public final class PlanarMapping implements InverseMapping {
    private final Vector3 origin;
    private final Vector3 sideU;
    private final Vector3 sideV;
    private final Vector3 dualU;
    private final Vector3 dualV;
    private final Vector3 normal;

    /**
     * @param origin the point of u = v = 0
     * @param sideU from the origin to u = 1, in scene units
     * @param sideV from the origin to v = 1, in scene units
     * @throws IllegalArgumentException if the sides are parallel, zero or not finite
     */
    public PlanarMapping(Vector3 origin, Vector3 sideU, Vector3 sideV) {
        if (!origin.isFinite()) {
            throw new IllegalArgumentException("origin of a planar mapping must be finite, but is " + origin);
        }
        Vector3 unitU = sideU.normalized();
        Vector3 unitV = sideV.normalized();
        this.normal = unitU.cross(unitV);
        double sine = normal.length();
        if (sine == 0) {
            throw new IllegalArgumentException(
                    "sides of a planar mapping must not be parallel, but are " + sideU + " and " + sideV);
        }
        this.origin = origin;
        this.sideU = sideU;
        this.sideV = sideV;
        double sineSquared = sine * sine;
        this.dualU = unitV.cross(normal).times(1 / sineSquared).times(1 / sideU.length());
        this.dualV = normal.cross(unitU).times(1 / sineSquared).times(1 / sideV.length());
    }

    @Override
    public void map(Hit hit) {
        hit.setMap(repeated(along(dualU, hit)), repeated(along(dualV, hit)));
        tangents(hit);
        Projection.ofTangents(hit, normal.x(), normal.y(), normal.z());
    }

    /** As {@link #map}, but what lies beyond the map by rounding stays at its border. */
    void mapWithin(Hit hit) {
        hit.setMap(within(along(dualU, hit)), within(along(dualV, hit)));
        tangents(hit);
    }

    private double along(Vector3 dual, Hit hit) {
        return (hit.x - origin.x()) * dual.x() + (hit.y - origin.y()) * dual.y() + (hit.z - origin.z()) * dual.z();
    }

    private void tangents(Hit hit) {
        hit.setTangents(sideU.x(), sideU.y(), sideU.z(), sideV.x(), sideV.y(), sideV.z());
    }

    static double repeated(double coordinate) {
        return coordinate >= 0 && coordinate <= 1 ? coordinate : coordinate - Math.floor(coordinate);
    }

    static double within(double coordinate) {
        return Math.max(0, Math.min(1, coordinate));
    }
}
