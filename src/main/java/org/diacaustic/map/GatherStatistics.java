package org.diacaustic.map;

import java.util.Arrays;

/**
 * What a look at some of the photons says about how to gather them all. Every n-th photon in the order of the tree is
 * looked at, so the answers are the same every time, and cost no more for many photons than for few.
 */
public final class GatherStatistics {
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
                    ? Math.sqrt(nearest.distanceSquared(count)) * tree.lengthUnit()
                    : Double.POSITIVE_INFINITY;
        }
        Arrays.sort(distances);
        return distances[looks / 2];
    }

    /**
     * The harmonic mean, over photons, of the number of photons within a radius of them, themselves included, that the
     * filter accepts there. Photons are where light is, so this is photons × πr² ÷ the area that light covers: the number to
     * expect in a gather [Thesis 4.8].
     *
     * @param radius in scene units
     * @param samples the number of photons to look at, at least 1
     * @return 0 if there are no photons
     */
    public static double harmonicMeanCount(PhotonTree tree, double radius, PhotonFilter filter, int samples) {
        requirePositive("samples", samples);
        int looks = Math.min(samples, tree.size());
        if (looks == 0) {
            return 0;
        }
        PhotonSearch search = new PhotonSearch(tree, filter);
        SurfacePoint at = new SurfacePoint();
        double sum = 0;
        for (int i = 0; i < looks; i++) {
            tree.position(place(i, looks, tree), at);
            search.start(at, radius);
            int count = 0;
            for (int found = search.next(); found >= 0; found = search.next()) {
                count += found;
            }
            // Rounding may put a photon beside itself.
            sum += 1.0 / Math.max(1, count);
        }
        return looks / sum;
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
