package org.diacaustic.map;

import org.diacaustic.math.Rgb;

/** Reads the k nearest photons. */
final class NearestLookup implements IlluminationMap.Lookup {
    /** The spacing of positions in single precision, in units of length: no two photons are known to be nearer. */
    private static final double RESOLUTION = 0x1p-23;

    private final PhotonTree tree;
    private final NearestPhotons nearest;
    private final Estimator.Nearest estimator;
    private final double maximumRadiusSquared;
    private long used;

    NearestLookup(PhotonTree tree, PhotonFilter filter, Estimator.Nearest estimator) {
        this.tree = tree;
        this.nearest = new NearestPhotons(tree, filter, estimator.count());
        this.estimator = estimator;
        double inUnits = estimator.maximumRadius() / tree.lengthUnit();
        this.maximumRadiusSquared = inUnits * inUnits;
    }

    @Override
    public void irradiance(SurfacePoint at, Rgb irradiance) {
        if (!PhotonSearch.canStart(at)) {
            irradiance.set(Double.NaN, Double.NaN, Double.NaN);
            return;
        }
        boolean enough = nearest.find(at, estimator.maximumRadius());
        int counting = enough ? estimator.count() - 1 : nearest.found();
        double radiusSquared = enough
                ? Math.max(nearest.distanceSquaredInUnits(counting), RESOLUTION * RESOLUTION)
                : maximumRadiusSquared;
        if (!(radiusSquared < Double.POSITIVE_INFINITY)) {
            irradiance.set(0, 0, 0);
            return;
        }
        double red = 0;
        double green = 0;
        double blue = 0;
        for (int i = 0; i < counting; i++) {
            int photon = nearest.photon(i);
            double weight = estimator.kernel().weight(nearest.distanceSquaredInUnits(i) / radiusSquared);
            red += weight * tree.red[photon];
            green += weight * tree.green[photon];
            blue += weight * tree.blue[photon];
        }
        used += counting;
        double scale = tree.powerUnit() / (Math.PI * radiusSquared) / tree.lengthUnit() / tree.lengthUnit();
        irradiance.set(red * scale, green * scale, blue * scale);
    }

    @Override
    public long nodesExamined() {
        return nearest.examined();
    }

    @Override
    public long photonsUsed() {
        return used;
    }
}
