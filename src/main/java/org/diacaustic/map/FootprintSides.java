package org.diacaustic.map;

/** The planes through the edges of a {@link Footprint}, and which of them hold what lies just in them. */
final class FootprintSides {
    /** What rounding may make of 0, in parts of the numbers that went in. */
    private static final double ROUNDING = 0x1p-40;

    /** Three numbers a plane: its normal, which points inwards and has any length. */
    final double[] normals = new double[3 * Footprint.LARGEST_CORNERS];

    /** Three numbers a plane: the middle of the edge, which is on it. */
    final double[] middles = new double[3 * Footprint.LARGEST_CORNERS];

    /** Whether what lies in the plane is inside. */
    final boolean[] holdsPlane = new boolean[Footprint.LARGEST_CORNERS];

    int count;

    /**
     * Puts a plane through every edge between corners that differ.
     *
     * @return false if the polygon is not convex, or an edge is along the eye's rays
     */
    boolean cut(double[] corners, double[] directions, int cornerCount) {
        count = 0;
        for (int corner = 0; corner < cornerCount; corner++) {
            int p = 3 * corner;
            int q = corner + 1 < cornerCount ? p + 3 : 0;
            boolean equal =
                    corners[p] == corners[q] && corners[p + 1] == corners[q + 1] && corners[p + 2] == corners[q + 2];
            if (!equal) {
                add(corners, directions, p, q);
                double side = sideOfOthers(corners, cornerCount, p, q);
                if (side == 0) {
                    return false;
                }
                orient(side);
            }
        }
        return true;
    }

    /**
     * Adds the plane through the edge from p to q. With p and q exchanged all numbers of the normal change their signs, and no
     * other bit: the footprint on the other side of the edge has the very same plane.
     */
    private void add(double[] corners, double[] directions, int p, int q) {
        double edgeX = corners[q] - corners[p];
        double edgeY = corners[q + 1] - corners[p + 1];
        double edgeZ = corners[q + 2] - corners[p + 2];
        double eyeX = directions[p] + directions[q];
        double eyeY = directions[p + 1] + directions[q + 1];
        double eyeZ = directions[p + 2] + directions[q + 2];
        int i = 3 * count++;
        normals[i] = edgeY * eyeZ - edgeZ * eyeY;
        normals[i + 1] = edgeZ * eyeX - edgeX * eyeZ;
        normals[i + 2] = edgeX * eyeY - edgeY * eyeX;
        middles[i] = 0.5 * (corners[p] + corners[q]);
        middles[i + 1] = 0.5 * (corners[p + 1] + corners[q + 1]);
        middles[i + 2] = 0.5 * (corners[p + 2] + corners[q + 2]);
    }

    /** On which side of the last plane the corners but p and q are: 1 or −1, or 0 if on neither or on both. */
    private double sideOfOthers(double[] corners, int cornerCount, int p, int q) {
        int i = 3 * (count - 1);
        double lowest = 0;
        double highest = 0;
        double farthest = 0;
        for (int other = 0; other < 3 * cornerCount; other += 3) {
            if (other != p && other != q) {
                double x = corners[other] - middles[i];
                double y = corners[other + 1] - middles[i + 1];
                double z = corners[other + 2] - middles[i + 2];
                double distance = normals[i] * x + normals[i + 1] * y + normals[i + 2] * z;
                lowest = Math.min(lowest, distance);
                highest = Math.max(highest, distance);
                farthest = Math.max(farthest, Math.abs(x) + Math.abs(y) + Math.abs(z));
            }
        }
        double zero =
                ROUNDING * farthest * (Math.abs(normals[i]) + Math.abs(normals[i + 1]) + Math.abs(normals[i + 2]));
        if (highest > zero && lowest >= -zero) {
            return 1;
        }
        return lowest < -zero && highest <= zero ? -1 : 0;
    }

    private void orient(double sign) {
        int i = 3 * (count - 1);
        normals[i] *= sign;
        normals[i + 1] *= sign;
        normals[i + 2] *= sign;
        holdsPlane[count - 1] = isFirst(normals[i], normals[i + 1], normals[i + 2]);
    }

    /**
     * True for just one of a direction and its opposite. What lies in a plane goes to the side that the plane's normal then
     * is for: as if all light were moved a little along x, less along y, least along z.
     */
    static boolean isFirst(double x, double y, double z) {
        return x > 0 || x == 0 && (y > 0 || y == 0 && z > 0);
    }
}
