package org.diacaustic.map;

/** A query that looks at photons in arrays one by one: those in the ball are counted, or kept in a heap of the k nearest. */
abstract class ColumnQuery extends GatherQuery {
    float x;
    float y;
    float z;
    float radiusSquared;

    private final PhotonColumns photons;
    private final BoundedHeap heap = new BoundedHeap();
    private int[] kept = new int[0];
    private boolean nearest;

    ColumnQuery(PhotonFilter filter, PhotonColumns photons) {
        super(filter);
        this.photons = photons;
    }

    /** Looks at every photon that may be within {@link #radiusSquared}, which may shrink meanwhile. */
    abstract void walk();

    /** Looks at a photon; whether the ball has shrunk. */
    final void look(int photon) {
        float distanceSquared = photons.distanceSquared(photon, x, y, z);
        if (distanceSquared <= radiusSquared && accepts(photons.normal[photon])) {
            if (!nearest) {
                count(photons.red[photon], photons.green[photon], photons.blue[photon]);
            } else {
                kept[heap.add(distanceSquared)] = photon;
                radiusSquared = heap.isFull() ? heap.largest() : radiusSquared;
            }
        }
    }

    @Override
    final void within(SurfacePoint at, double radius) {
        start(at, radius);
        nearest = false;
        walk();
    }

    @Override
    final void nearest(SurfacePoint at, int count, double maximumRadius) {
        start(at, maximumRadius);
        nearest = true;
        int room = Math.min(count, photons.size());
        if (kept.length < room) {
            kept = new int[room];
        }
        heap.clear(room);
        if (room > 0) {
            walk();
        }
        for (int i = 0; i < heap.size(); i++) {
            int photon = kept[i];
            count(photons.red[photon], photons.green[photon], photons.blue[photon]);
        }
        farthestSquared = heap.size() > 0 ? heap.largest() : 0;
    }

    private void start(SurfacePoint at, double radius) {
        begin(at);
        x = (float) at.x;
        y = (float) at.y;
        z = (float) at.z;
        radiusSquared = (float) (radius * radius);
    }
}
