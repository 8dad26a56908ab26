package org.diacaustic.map;

import org.diacaustic.math.Rgb;

/** Reads photons within a fixed radius. */
final class RadiusLookup implements IlluminationMap.Lookup {
    private final PhotonTree tree;
    private final PhotonSearch search;
    private final double radius;
    private final Kernel kernel;
    private final double scale;
    private long used;

    /** @param scale what the sum of weighted powers, in units of power, is multiplied by */
    RadiusLookup(PhotonTree tree, PhotonFilter filter, double radius, Kernel kernel, double scale) {
        this.tree = tree;
        this.search = new PhotonSearch(tree, filter);
        this.radius = radius;
        this.kernel = kernel;
        this.scale = scale;
    }

    @Override
    public void irradiance(SurfacePoint at, Rgb irradiance) {
        if (!PhotonSearch.canStart(at)) {
            irradiance.set(Double.NaN, Double.NaN, Double.NaN);
            return;
        }
        double red = 0;
        double green = 0;
        double blue = 0;
        search.start(at, radius);
        // A radius whose square vanishes still has photons at distance 0.
        float radiusSquared = Math.max(search.radiusSquared(), Float.MIN_VALUE);
        for (int found = search.next(); found >= 0; found = search.next()) {
            for (int i = 0; i < found; i++) {
                int photon = search.photons[i];
                double weight = kernel.weight(search.distancesSquared[i] / radiusSquared);
                red += weight * tree.red[photon];
                green += weight * tree.green[photon];
                blue += weight * tree.blue[photon];
            }
            used += found;
        }
        irradiance.set(red * scale, green * scale, blue * scale);
    }

    @Override
    public long nodesExamined() {
        return search.examined();
    }

    @Override
    public long photonsUsed() {
        return used;
    }
}
