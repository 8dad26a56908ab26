package org.diacaustic.map;

import org.diacaustic.math.Rgb;

/**
 * The thesis' photon map: an object for each photon, put into a tree that is never balanced; levels compare x, y, z in turn,
 * and what is smaller goes left [Thesis 4.5, 4.8].
 */
final class ObjectTreeIndex implements PhotonIndex {
    /** Of an object on a 64-bit machine with compressed references: a header of 12, seven numbers, two references. */
    private static final int OBJECT_BYTES = 48;

    private final int size;
    private Photon root;

    ObjectTreeIndex(PhotonStore store) {
        size = store.size();
        SurfacePoint at = new SurfacePoint();
        Rgb power = new Rgb();
        for (int i = 0; i < size; i++) {
            store.position(i, at);
            store.power(i, power);
            insert(new Photon(at, power));
        }
    }

    private void insert(Photon photon) {
        if (root == null) {
            root = photon;
            return;
        }
        Photon node = root;
        for (int axis = 0; ; axis = axis == 2 ? 0 : axis + 1) {
            boolean less = photon.along(axis) < node.along(axis);
            Photon child = less ? node.left : node.right;
            if (child == null) {
                if (less) {
                    node.left = photon;
                } else {
                    node.right = photon;
                }
                return;
            }
            node = child;
        }
    }

    @Override
    public long bytes() {
        return (long) OBJECT_BYTES * size;
    }

    @Override
    public GatherQuery query(PhotonFilter filter) {
        return new Query(filter);
    }

    private static final class Photon {
        final float x;
        final float y;
        final float z;
        final float red;
        final float green;
        final float blue;
        final int normal;
        Photon left;
        Photon right;

        Photon(SurfacePoint at, Rgb power) {
            x = (float) at.x;
            y = (float) at.y;
            z = (float) at.z;
            red = (float) power.red;
            green = (float) power.green;
            blue = (float) power.blue;
            normal = PackedNormal.of(at.normalX, at.normalY, at.normalZ);
        }

        float along(int axis) {
            return axis == 0 ? x : axis == 1 ? y : z;
        }
    }

    private final class Query extends GatherQuery {
        private final BoundedHeap heap = new BoundedHeap();
        private Photon[] kept = new Photon[0];
        private boolean nearest;
        private float x;
        private float y;
        private float z;
        private float radiusSquared;

        Query(PhotonFilter filter) {
            super(filter);
        }

        @Override
        void within(SurfacePoint at, double radius) {
            start(at, radius);
            nearest = false;
            visit(root, 0);
        }

        @Override
        void nearest(SurfacePoint at, int count, double maximumRadius) {
            start(at, maximumRadius);
            nearest = true;
            int room = Math.min(count, size);
            if (kept.length < room) {
                kept = new Photon[room];
            }
            heap.clear(room);
            visit(root, 0);
            for (int i = 0; i < heap.size(); i++) {
                count(kept[i].red, kept[i].green, kept[i].blue);
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

        private void visit(Photon photon, int axis) {
            if (photon == null) {
                return;
            }
            int next = axis == 2 ? 0 : axis + 1;
            float beyond = (axis == 0 ? x : axis == 1 ? y : z) - photon.along(axis);
            visit(beyond < 0 ? photon.left : photon.right, next);
            look(photon);
            if (beyond * beyond <= radiusSquared) {
                visit(beyond < 0 ? photon.right : photon.left, next);
            }
        }

        private void look(Photon photon) {
            float dx = photon.x - x;
            float dy = photon.y - y;
            float dz = photon.z - z;
            float distanceSquared = dx * dx + dy * dy + dz * dz;
            if (distanceSquared <= radiusSquared && accepts(photon.normal)) {
                if (!nearest) {
                    count(photon.red, photon.green, photon.blue);
                } else {
                    kept[heap.add(distanceSquared)] = photon;
                    radiusSquared = heap.isFull() ? heap.largest() : radiusSquared;
                }
            }
        }
    }
}
