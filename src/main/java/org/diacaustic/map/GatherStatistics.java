package org.diacaustic.map;

import java.util.Arrays;
import org.diacaustic.math.Vector3;

/**
 * What a look at some of the photons says about how to gather them all. Every n-th photon in the order of the tree is
 * looked at, so the answers are the same every time, and cost no more for many photons than for few.
 */
public final class GatherStatistics {
    /** Multiples of these are evenly spread in two dimensions [Roberts 2018]. */
    private static final double GOLDEN = 0.7548776662466927;

    private static final double SILVER = 0.5698402909980532;

    private GatherStatistics() {}

    /**
     * The median, over photons, of the distance to their k-th nearest neighbour that the filter accepts there.
     *
     * @param count k, at least 1
     * @param samples the number of photons to look at, at least 1
     * @return in scene units; infinite if most photons have fewer than k neighbours, or if there are no photons
     */
    public static double medianNeighbourDistance(PhotonTree tree, int count, PhotonFilter filter, int samples) {
        requirePositive("neighbours", count);
        requirePositive("samples", samples);
        int looks = Math.min(samples, tree.size());
        if (looks == 0) {
            return Double.POSITIVE_INFINITY;
        }
        // A photon is the nearest to itself.
        NearestPhotons nearest = new NearestPhotons(tree, filter, count + 1);
        SurfacePoint at = new SurfacePoint();
        double[] distances = new double[looks];
        for (int i = 0; i < looks; i++) {
            tree.position(place(i, looks, tree), at);
            distances[i] = nearest.find(at, Double.POSITIVE_INFINITY)
                    ? Math.sqrt(nearest.distanceSquaredInUnits(count)) * tree.lengthUnit()
                    : Double.POSITIVE_INFINITY;
        }
        Arrays.sort(distances);
        return distances[looks / 2];
    }

    /**
     * The number of photons to expect in a gather [Thesis 4.8]: photons × πr² ÷ the area within reach of any. It is
     * found as the harmonic mean of the number of photons around places within reach of photons. A place that c photons
     * reach is looked at c times as often as one that a single photon does, and the harmonic mean makes up for just that.
     *
     * @param radius in scene units
     * @param samples the number of places to look at, at least 1
     * @return 0 if there are no photons
     */
    public static double expectedCount(PhotonTree tree, double radius, PhotonFilter filter, int samples) {
        requirePositive("samples", samples);
        if (tree.size() == 0) {
            return 0;
        }
        PhotonSearch search = new PhotonSearch(tree, filter);
        SurfacePoint at = new SurfacePoint();
        double sum = 0;
        for (int i = 0; i < samples; i++) {
            tree.position(place(i, samples, tree), at);
            moveAlongSurface(at, radius * Math.sqrt((i + 0.5) * GOLDEN % 1), 2 * Math.PI * (i * SILVER % 1));
            search.start(at, radius);
            int count = 0;
            for (int found = search.next(); found >= 0; found = search.next()) {
                count += found;
            }
            // Rounding may put a photon out of its own reach.
            sum += 1.0 / Math.max(1, count);
        }
        return samples / sum;
    }

    /** Moves the point a distance across its normal. */
    private static void moveAlongSurface(SurfacePoint at, double distance, double angle) {
        Vector3 normal = new Vector3(at.normalX, at.normalY, at.normalZ);
        Vector3 u = normal.perpendicular();
        Vector3 v = normal.cross(u);
        Vector3 way = u.times(distance * StrictMath.cos(angle)).plus(v.times(distance * StrictMath.sin(angle)));
        at.x += way.x();
        at.y += way.y();
        at.z += way.z();
    }

    private static int place(int sample, int samples, PhotonTree tree) {
        return (int) ((2L * sample + 1) * tree.size() / (2L * samples));
    }

    private static void requirePositive(String what, int value) {
        if (value < 1) {
            throw new IllegalArgumentException(what + " must be at least 1, but are " + value);
        }
    }
}
