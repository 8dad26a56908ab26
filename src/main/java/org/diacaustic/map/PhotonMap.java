package org.diacaustic.map;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.parallel.Workers;

/**
 * The global photon map [Thesis 4.5, 4.8]: irradiance from the photons near a point. Several maps may read one tree.
 * Photons know no edges: where a surface ends within the radius, the disc is only partly on it and the estimate is
 * too small by that part.
 */
public final class PhotonMap implements IlluminationMap {
    private final PhotonTree tree;
    private final Estimator estimator;
    private final PhotonFilter filter;

    private PhotonMap(PhotonTree tree, Estimator estimator, PhotonFilter filter) {
        this.tree = tree;
        this.estimator = estimator;
        this.filter = filter;
    }

    /** A map that reads the photons of a tree. */
    public static PhotonMap over(PhotonTree tree, Estimator estimator, PhotonFilter filter) {
        return new PhotonMap(tree, estimator, filter);
    }

    /** A map of the photons of a store, which is empty afterwards; see {@link PhotonTree#movedFrom}. */
    public static PhotonMap over(PhotonStore store, Estimator estimator, PhotonFilter filter, Workers workers) {
        return over(PhotonTree.movedFrom(store, workers), estimator, filter);
    }

    /** A reader for one task. It gives what is not a number where it is asked with what is not finite. */
    @Override
    public Lookup lookup() {
        if (estimator instanceof Estimator.Nearest nearest) {
            return new NearestLookup(tree, filter, nearest);
        }
        if (estimator instanceof Estimator.Density density) {
            return new RadiusLookup(tree, filter, density.radius(), density.kernel(), perArea(density.radius()));
        }
        Estimator.ExpectedCount expected = (Estimator.ExpectedCount) estimator;
        return new RadiusLookup(
                tree, filter, expected.radius(), Kernel.CONSTANT, tree.powerUnit() / expected.expectedCount());
    }

    /** The unit of power ÷ the area of a disc, whose square need not be in range. */
    private double perArea(double radius) {
        double unit = Arithmetic.powerOfTwoNear(radius);
        double inUnits = radius / unit;
        return tree.powerUnit() / (Math.PI * inUnits * inUnits) / unit / unit;
    }

    @Override
    public long bytes() {
        return tree.bytes();
    }

    public PhotonTree tree() {
        return tree;
    }

    public Estimator estimator() {
        return estimator;
    }

    public PhotonFilter filter() {
        return filter;
    }
}
