package org.diacaustic.material;

/** Gradient noise on a lattice of unit cubes [Perlin 2002, "Improving Noise"], with hashed gradients. */
final class GradientNoise {
    private GradientNoise() {}

    /** A sum of octaves, each of twice the frequency and half the strength of the one before; about −1..1. */
    static double turbulence(double x, double y, double z, int octaves) {
        double sum = 0;
        double frequency = 1;
        for (int octave = 0; octave < octaves; octave++) {
            sum += at(x * frequency, y * frequency, z * frequency, octave) / frequency;
            frequency *= 2;
        }
        return sum;
    }

    private static double at(double x, double y, double z, int octave) {
        double fx = Math.floor(x);
        double fy = Math.floor(y);
        double fz = Math.floor(z);
        long ix = (long) fx;
        long iy = (long) fy;
        long iz = (long) fz;
        double rx = x - fx;
        double ry = y - fy;
        double rz = z - fz;
        double sx = fade(rx);
        double sy = fade(ry);
        double sz = fade(rz);
        double[] edge = EDGES;
        return mix(
                sz,
                mix(
                        sy,
                        mix(
                                sx,
                                corner(ix, iy, iz, rx, ry, rz, octave, edge),
                                corner(ix + 1, iy, iz, rx - 1, ry, rz, octave, edge)),
                        mix(
                                sx,
                                corner(ix, iy + 1, iz, rx, ry - 1, rz, octave, edge),
                                corner(ix + 1, iy + 1, iz, rx - 1, ry - 1, rz, octave, edge))),
                mix(
                        sy,
                        mix(
                                sx,
                                corner(ix, iy, iz + 1, rx, ry, rz - 1, octave, edge),
                                corner(ix + 1, iy, iz + 1, rx - 1, ry, rz - 1, octave, edge)),
                        mix(
                                sx,
                                corner(ix, iy + 1, iz + 1, rx, ry - 1, rz - 1, octave, edge),
                                corner(ix + 1, iy + 1, iz + 1, rx - 1, ry - 1, rz - 1, octave, edge))));
    }

    /** The twelve edge directions of a cube, four of them twice, so that four bits choose one. */
    private static final double[] EDGES = {
        1, 1, 0, -1, 1, 0, 1, -1, 0, -1, -1, 0, 1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, -1, 0, 1, 1, 0, -1, 1, 0, 1, -1, 0,
        -1, -1, 1, 1, 0, -1, 1, 0, 0, -1, 1, 0, -1, -1
    };

    private static double corner(
            long ix, long iy, long iz, double rx, double ry, double rz, int octave, double[] edges) {
        long hash = ix * 0x9E3779B97F4A7C15L ^ iy * 0xC2B2AE3D27D4EB4FL ^ iz * 0x165667B19E3779F9L ^ octave;
        hash = (hash ^ (hash >>> 32)) * 0xD6E8FEB86659FD93L;
        int edge = 3 * (int) (hash >>> 60);
        return edges[edge] * rx + edges[edge + 1] * ry + edges[edge + 2] * rz;
    }

    private static double fade(double t) {
        return t * t * t * (t * (t * 6 - 15) + 10);
    }

    private static double mix(double share, double a, double b) {
        return a + share * (b - a);
    }
}
