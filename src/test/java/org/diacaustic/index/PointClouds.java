package org.diacaustic.index;

import java.util.SplittableRandom;

/** Points to build trees over. */
final class PointClouds {
    final float[] x;
    final float[] y;
    final float[] z;

    PointClouds(int size) {
        x = new float[size];
        y = new float[size];
        z = new float[size];
    }

    /** Uniform in a cube, each coordinate a multiple of 2^-20: the numbers that the cases were computed with. */
    static PointClouds cube(int size, long seed) {
        PointClouds cloud = new PointClouds(size);
        long state = seed;
        for (int i = 0; i < size; i++) {
            state = state * 6364136223846793005L + 1442695040888963407L;
            cloud.x[i] = (state >>> 44) * 0x1p-20f;
            state = state * 6364136223846793005L + 1442695040888963407L;
            cloud.y[i] = (state >>> 44) * 0x1p-20f;
            state = state * 6364136223846793005L + 1442695040888963407L;
            cloud.z[i] = (state >>> 44) * 0x1p-20f;
        }
        return cloud;
    }

    static PointClouds equal(int size, float px, float py, float pz) {
        PointClouds cloud = new PointClouds(size);
        for (int i = 0; i < size; i++) {
            cloud.set(i, px, py, pz);
        }
        return cloud;
    }

    /** 16³ points, a step of 1/16 apart. */
    static PointClouds lattice() {
        PointClouds cloud = new PointClouds(4096);
        for (int i = 0; i < 4096; i++) {
            cloud.set(i, (i >> 8) / 16f, (i >> 4 & 15) / 16f, (i & 15) / 16f);
        }
        return cloud;
    }

    /** Lines of light and a thin haze on a floor and a few steps. */
    static PointClouds clusters(int size, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        PointClouds cloud = new PointClouds(size);
        for (int i = 0; i < size; i++) {
            double u = random.nextDouble();
            double v = random.nextDouble();
            double spread = random.nextInt(4) == 0 ? 0.3 : 0.002;
            cloud.set(i, (float) (u + spread * random.nextDouble()), (float) (0.25 * random.nextInt(3)), (float)
                    (0.3 * Math.sin(7 * u) + spread * v));
        }
        return cloud;
    }

    PointClouds set(int i, float px, float py, float pz) {
        x[i] = px;
        y[i] = py;
        z[i] = pz;
        return this;
    }

    PointClouds copy() {
        PointClouds copy = new PointClouds(size());
        System.arraycopy(x, 0, copy.x, 0, size());
        System.arraycopy(y, 0, copy.y, 0, size());
        System.arraycopy(z, 0, copy.z, 0, size());
        return copy;
    }

    int size() {
        return x.length;
    }

    float distanceSquared(int i, float px, float py, float pz) {
        float dx = x[i] - px;
        float dy = y[i] - py;
        float dz = z[i] - pz;
        return dx * dx + dy * dy + dz * dz;
    }
}
