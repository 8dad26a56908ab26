package org.diacaustic.map;

/**
 * A hash table of cubic cells, as wide as the gather radius that is expected, each a range of the photons [Teschner et al.
 * 2003]. The nearest are found in balls of growing radius.
 */
final class HashGridIndex implements PhotonIndex {
    private final PhotonColumns photons;

    /** Where each bucket begins. */
    private final int[] starts;

    private final double cell;

    HashGridIndex(PhotonStore store, double cell) {
        PhotonColumns source = PhotonColumns.of(store);
        int size = source.size();
        this.cell = cell;
        photons = new PhotonColumns(size);
        starts = new int[Math.max(1, Integer.highestOneBit(size)) + 1];
        for (int i = 0; i < size; i++) {
            starts[bucketOf(source, i) + 1]++;
        }
        for (int bucket = 1; bucket < starts.length; bucket++) {
            starts[bucket] += starts[bucket - 1];
        }
        int[] next = starts.clone();
        for (int i = 0; i < size; i++) {
            photons.copy(source, i, next[bucketOf(source, i)]++);
        }
    }

    private int bucketOf(PhotonColumns columns, int i) {
        return bucket(place(columns.x[i]), place(columns.y[i]), place(columns.z[i]));
    }

    private long place(double coordinate) {
        return (long) Math.floor(coordinate / cell);
    }

    private int bucket(long x, long y, long z) {
        long hash = x * 73856093L ^ y * 19349663L ^ z * 83492791L;
        return (int) ((hash * 0x9E3779B97F4A7C15L >>> 33) % (starts.length - 1));
    }

    @Override
    public long bytes() {
        return photons.bytes() + 4L * starts.length;
    }

    @Override
    public GatherQuery query(PhotonFilter filter) {
        return new Query(filter);
    }

    private final class Query extends GatherQuery {
        private final Ball ball;

        Query(PhotonFilter filter) {
            super(filter);
            ball = new Ball(filter);
        }

        @Override
        void within(SurfacePoint at, double radius) {
            ball.within(at, radius);
            take();
        }

        @Override
        void nearest(SurfacePoint at, int count, double maximumRadius) {
            double radius = Math.min(cell, maximumRadius);
            ball.nearest(at, count, radius);
            while (ball.found < count && radius < maximumRadius) {
                // Beyond this every photon is looked at anyway.
                radius = ball.isSmall(radius) ? Math.min(2 * radius, maximumRadius) : maximumRadius;
                ball.nearest(at, count, radius);
            }
            take();
        }

        private void take() {
            sum.set(ball.sum);
            found = ball.found;
            farthestSquared = ball.farthestSquared;
        }
    }

    private final class Ball extends ColumnQuery {
        Ball(PhotonFilter filter) {
            super(filter, photons);
        }

        /** Whether fewer cells than buckets are within the radius. */
        boolean isSmall(double radius) {
            return Math.pow(2 * radius / cell + 2, 3) < starts.length;
        }

        @Override
        void walk() {
            double radius = Math.sqrt(radiusSquared) * (1 + 0x1p-20);
            if (!isSmall(radius)) {
                for (int i = 0; i < photons.size(); i++) {
                    look(i);
                }
                return;
            }
            long highX = place(x + radius);
            long highY = place(y + radius);
            long highZ = place(z + radius);
            for (long i = place(x - radius); i <= highX; i++) {
                for (long j = place(y - radius); j <= highY; j++) {
                    for (long k = place(z - radius); k <= highZ; k++) {
                        walk(i, j, k);
                    }
                }
            }
        }

        private void walk(long i, long j, long k) {
            int bucket = bucket(i, j, k);
            for (int photon = starts[bucket]; photon < starts[bucket + 1]; photon++) {
                // Other cells may have the same bucket.
                if (place(photons.x[photon]) == i && place(photons.y[photon]) == j && place(photons.z[photon]) == k) {
                    look(photon);
                }
            }
        }
    }
}
