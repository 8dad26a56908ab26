package org.diacaustic.map;

import org.diacaustic.parallel.Workers;

/** The library's own: see {@link PhotonTree}. */
final class ArrangedIndex implements PhotonIndex {
    private final PhotonTree tree;

    ArrangedIndex(PhotonStore store, Workers workers) {
        tree = PhotonTree.movedFrom(store, workers);
    }

    @Override
    public long bytes() {
        return tree.bytes();
    }

    @Override
    public GatherQuery query(PhotonFilter filter) {
        return new Query(filter);
    }

    private final class Query extends GatherQuery {
        private final PhotonFilter filter;
        private final PhotonSearch search;
        private final float squaredUnit = (float) (tree.lengthUnit() * tree.lengthUnit());
        private NearestPhotons nearest;
        private int nearestCount;

        Query(PhotonFilter filter) {
            super(filter);
            this.filter = filter;
            this.search = new PhotonSearch(tree, filter);
        }

        @Override
        void within(SurfacePoint at, double radius) {
            begin(at);
            search.start(at, radius);
            for (int next = search.next(); next >= 0; next = search.next()) {
                for (int i = 0; i < next; i++) {
                    int photon = search.photons[i];
                    count(tree.red[photon], tree.green[photon], tree.blue[photon]);
                }
            }
        }

        @Override
        void nearest(SurfacePoint at, int count, double maximumRadius) {
            if (nearestCount != count) {
                nearest = new NearestPhotons(tree, filter, count);
                nearestCount = count;
            }
            begin(at);
            boolean enough = nearest.find(at, maximumRadius);
            for (int i = 0; i < nearest.found(); i++) {
                int photon = nearest.photon(i);
                count(tree.red[photon], tree.green[photon], tree.blue[photon]);
                if (!enough) {
                    farthestSquared = Math.max(farthestSquared, nearest.distanceSquaredInUnits(i) * squaredUnit);
                }
            }
            if (enough) {
                farthestSquared = nearest.distanceSquaredInUnits(count - 1) * squaredUnit;
            }
        }
    }
}
