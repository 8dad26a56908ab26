package org.diacaustic.trial;

import java.util.Locale;
import java.util.SplittableRandom;
import org.diacaustic.map.Estimator;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.map.Kernel;
import org.diacaustic.map.NearestPhotons;
import org.diacaustic.map.PhotonFilter;
import org.diacaustic.map.PhotonMap;
import org.diacaustic.map.PhotonStore;
import org.diacaustic.map.PhotonTree;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;
import org.diacaustic.stability.Values;

/** Photons found by place, and photons that no store may take. */
final class PhotonTreeTrials {
    /** Positions are kept in single precision: cases allow squared distances to be off by as much. */
    private static final double SINGLE = 2e-7;

    private PhotonTreeTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "kdtree_knn",
                "Photons in a PhotonTree about the middle of their box, asked by the search that every lookup makes: the k"
                        + " nearest, and all in the closed ball of the radius, which must be as many as expected; squared"
                        + " distances must be right within 2e-7. The depth counts the nodes from the root to a leaf, each a"
                        + " bucket of at most 32 photons, and must be at most the expected one of a tree with a photon in each"
                        + " node. Photons on one spot must give a finite irradiance.",
                PhotonTreeTrials::nearest);
        operations.add(
                "kdtree_reject",
                "The bad photon is offered to the store amid the good ones: it must be counted as left out, and every lookup"
                        + " must give the same bits as without it.",
                PhotonTreeTrials::reject);
    }

    private static void nearest(NumericCase asked, Checks checks) {
        Values inputs = asked.inputs();
        double[][] points = PhotonPlaces.of(inputs);
        PhotonTree tree = tree(points);
        SurfacePoint query = PhotonPlaces.at(inputs.vector("query"));
        int k = (int) Math.min(Integer.MAX_VALUE - 8, positive(inputs.integer("k"), "k"));
        NearestPhotons nearest = new NearestPhotons(tree, PhotonFilter.NONE, k);
        nearest.find(query, Double.POSITIVE_INFINITY);
        checks.same("returned", asked.expected().integer("returned"), (long) nearest.found());
        if (asked.expected().has("kth_distance_sq")) {
            double farthest = 0;
            double sum = 0;
            for (int i = 0; i < nearest.found(); i++) {
                farthest = Math.max(farthest, nearest.distanceSquared(i));
                sum += nearest.distanceSquared(i);
            }
            distance(checks, asked.expected(), "kth_distance_sq", farthest);
            distance(checks, asked.expected(), "sum_of_k_distances_sq", sum);
        }
        NearestPhotons ball = new NearestPhotons(tree, PhotonFilter.NONE, Math.max(1, points.length));
        ball.find(query, Math.sqrt(inputs.number("radius_sq")));
        checks.same("count_in_radius_closed", asked.expected().integer("count_in_radius_closed"), (long) ball.found());
        checks.rule(
                "max_tree_depth",
                "at most " + asked.expected().integer("max_tree_depth"),
                Integer.toString(tree.depth()),
                tree.depth() <= asked.expected().integer("max_tree_depth"));
        checks.holds("irradiance is finite", isFinite(tree, query, Math.max(2, k)));
        checks.note("balls are closed: a photon at exactly the radius counts, here and in every lookup");
    }

    private static void distance(Checks checks, Values expected, String name, double got) {
        double exact = expected.number(name);
        checks.number(name, exact, got, SINGLE * exact);
    }

    private static boolean isFinite(PhotonTree tree, SurfacePoint query, int k) {
        Estimator estimator = new Estimator.Nearest(k, Double.POSITIVE_INFINITY, Kernel.EPANECHNIKOV);
        double irradiance = StoredPhotons.irradiance(tree, estimator, PhotonFilter.NONE, query);
        return irradiance >= 0 && irradiance < Double.POSITIVE_INFINITY;
    }

    private static PhotonTree tree(double[][] points) {
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (double[] point : points) {
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], point[axis]);
                high[axis] = Math.max(high[axis], point[axis]);
            }
        }
        Vector3 middle = points.length == 0
                ? Vector3.ZERO
                : new Vector3((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2);
        StoredPhotons photons = new StoredPhotons(middle, 1, points.length, 1);
        for (double[] point : points) {
            photons.add(PhotonPlaces.at(point));
        }
        return photons.tree();
    }

    private static void reject(NumericCase asked, Checks checks) {
        String bad = asked.inputs().text("bad");
        int good = (int) positive(asked.inputs().integer("good_photons"), "good_photons");
        StoredPhotons alone = new StoredPhotons(Vector3.ZERO, 1, good + 1, 1);
        StoredPhotons amid = new StoredPhotons(Vector3.ZERO, 1, good + 1, 1);
        SplittableRandom random = new SplittableRandom(1);
        SurfacePoint[] places = new SurfacePoint[good];
        for (int i = 0; i < good; i++) {
            if (i == good / 2) {
                addBad(amid, bad);
            }
            places[i] = StoredPhotons.floor(random.nextDouble(), random.nextDouble());
            alone.add(places[i]);
            amid.add(places[i]);
        }
        PhotonStore store = amid.store();
        checks.same("photons stored", good, store.size());
        checks.same("photons left out and counted", 1L, store.rejectedCount());
        PhotonTree tree = amid.tree();
        PhotonTree other = alone.tree();
        checks.same("depth of the tree", other.depth(), tree.depth());
        checks.same("lookups that differ", 0, differences(other, tree, places));
    }

    private static int differences(PhotonTree expected, PhotonTree tree, SurfacePoint[] places) {
        int different = 0;
        for (Estimator estimator : new Estimator[] {
            new Estimator.Density(0.1, Kernel.CONE),
            new Estimator.Nearest(10, Double.POSITIVE_INFINITY, Kernel.CONSTANT)
        }) {
            IlluminationMap.Lookup one = PhotonMap.over(expected, estimator, PhotonFilter.TWO_SIDED_NORMAL)
                    .lookup();
            IlluminationMap.Lookup two = PhotonMap.over(tree, estimator, PhotonFilter.TWO_SIDED_NORMAL)
                    .lookup();
            Rgb first = new Rgb();
            Rgb second = new Rgb();
            for (SurfacePoint place : places) {
                one.irradiance(place, first);
                two.irradiance(place, second);
                different += Double.compare(first.green, second.green) == 0 ? 0 : 1;
            }
        }
        return different;
    }

    /** Adds the photon that a case calls, say, "NaN position" or "negative power". */
    private static void addBad(StoredPhotons photons, String bad) {
        String[] words = bad.toLowerCase(Locale.ROOT).strip().split("\\s+");
        if (words.length != 2) {
            throw new CaseFault("inputs.bad should be a value and what has it, such as NaN position, but is " + bad);
        }
        double value = switch (words[0]) {
            case "nan" -> Double.NaN;
            case "inf", "+inf", "infinite", "infinity", "+infinity" -> Double.POSITIVE_INFINITY;
            case "-inf", "-infinity" -> Double.NEGATIVE_INFINITY;
            case "negative" -> -1;
            case "zero" -> 0;
            default -> throw new CaseFault("inputs.bad: '" + words[0] + "' is no value that is known here");
        };
        boolean isBad = !Double.isFinite(value);
        SurfacePoint at = StoredPhotons.floor(0.5, 0.5);
        Rgb power = new Rgb().set(1, 1, 1);
        if (words[1].equals("position") && isBad) {
            at.x = value;
        } else if ((words[1].equals("power") || words[1].equals("flux")) && value != 0) {
            power.green = value;
        } else if (words[1].equals("normal") && (isBad || value == 0)) {
            at.normalY = value;
        } else {
            throw new CaseFault("inputs.bad: nothing is wrong with a photon of " + bad);
        }
        photons.add(at, power);
    }

    private static long positive(long number, String name) {
        if (number < 1) {
            throw new CaseFault("inputs." + name + " should be at least 1, but is " + number);
        }
        return number;
    }
}
