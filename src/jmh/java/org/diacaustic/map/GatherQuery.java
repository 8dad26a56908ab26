package org.diacaustic.map;

import org.diacaustic.math.Rgb;

/**
 * What an index is asked, and what it found. Balls are closed; distances are computed in floats. Working storage of one
 * task.
 */
abstract class GatherQuery {
    /** Of the powers of the photons found. */
    final Rgb sum = new Rgb();

    /** The number of photons found. */
    int found;

    /** The squared distance of the last of the nearest. */
    float farthestSquared;

    private final double cosine;
    private double normalX;
    private double normalY;
    private double normalZ;

    GatherQuery(PhotonFilter filter) {
        this.cosine = filter.cosine();
    }

    /** Finds the photons within a radius. */
    abstract void within(SurfacePoint at, double radius);

    /** Finds the k nearest photons, or all if there are fewer within the radius. */
    abstract void nearest(SurfacePoint at, int count, double maximumRadius);

    final void begin(SurfacePoint at) {
        sum.set(0, 0, 0);
        found = 0;
        farthestSquared = 0;
        normalX = at.normalX;
        normalY = at.normalY;
        normalZ = at.normalZ;
    }

    final boolean accepts(int normal) {
        return Double.isNaN(cosine) || PackedNormal.isWithin(normal, cosine, normalX, normalY, normalZ);
    }

    final void count(float red, float green, float blue) {
        sum.add(red, green, blue);
        found++;
    }
}
