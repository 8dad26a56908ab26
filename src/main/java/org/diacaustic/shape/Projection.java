package org.diacaustic.shape;

/** What a mapping from space does to the tangents of a surface that is not its own. */
final class Projection {
    private Projection() {}

    /**
     * Brings the tangents of the mapping's own surface to the surface that was hit, along a direction that changes
     * neither u nor v. Where the surface lies along that direction they are not defined, and zero.
     */
    static void ofTangents(Hit hit, double x, double y, double z) {
        double rise = x * hit.normalX + y * hit.normalY + z * hit.normalZ;
        if (rise == 0) {
            hit.setTangents(0, 0, 0, 0, 0, 0);
            return;
        }
        double u = -(hit.tangentUX * hit.normalX + hit.tangentUY * hit.normalY + hit.tangentUZ * hit.normalZ) / rise;
        double v = -(hit.tangentVX * hit.normalX + hit.tangentVY * hit.normalY + hit.tangentVZ * hit.normalZ) / rise;
        hit.setTangents(
                Math.fma(u, x, hit.tangentUX),
                Math.fma(u, y, hit.tangentUY),
                Math.fma(u, z, hit.tangentUZ),
                Math.fma(v, x, hit.tangentVX),
                Math.fma(v, y, hit.tangentVY),
                Math.fma(v, z, hit.tangentVZ));
    }
}
