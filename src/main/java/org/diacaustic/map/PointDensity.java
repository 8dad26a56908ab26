package org.diacaustic.map;

import org.diacaustic.index.BoxTree;
import org.diacaustic.index.BoxWalk;
import org.diacaustic.math.Rgb;

/**
 * Finds the density of a mesh's light at points. A triangle counts if the point, moved along the triangle's normal, is in it,
 * and is not farther off than a quarter of its longest edge: so far the chord of a third of a circle is from its arc. With light
 * paths to follow, a triangle's density is that of its ray which lands at the point, if there is one.
 * Working storage of one task.
 */
final class PointDensity {
    /** The largest depth, in parts of the longest edge. */
    private static final double DEPTH = 0.25;

    private static final double DEPTH_SQUARED = DEPTH * DEPTH;

    /** How far around the point there may be triangles whose cells light it, in parts of the longest edge. */
    private static final double AROUND = 0.25;

    private final CausticMesh mesh;
    private final BoxWalk walk = new BoxWalk();
    /** Null if none are looked for. */
    private final PointRays rays;

    private SurfacePoint point;
    private long used;

    /** The longest edge of the triangles that the point is in, in units of length. */
    private double longestFound;

    /** Where is asked, from the middle of a leaf, in units of length. */
    private double x;

    private double y;
    private double z;

    /** A triangle's second and third vertex, from the first. */
    private double bx;

    private double by;
    private double bz;
    private double cx;
    private double cy;
    private double cz;

    /** The normal of a triangle: its length is twice the area. */
    private double normalX;

    private double normalY;
    private double normalZ;

    /** @param paths null if triangles have the same density everywhere */
    PointDensity(CausticMesh mesh, LightPaths paths) {
        this.mesh = mesh;
        this.rays = paths == null ? null : new PointRays(mesh.seeds, paths);
    }

    void find(SurfacePoint at, Rgb irradiance) {
        if (!PhotonSearch.canStart(at)) {
            irradiance.set(Double.NaN, Double.NaN, Double.NaN);
            return;
        }
        irradiance.set(0, 0, 0);
        point = at;
        if (rays != null) {
            rays.start(at);
        }
        double unit = mesh.lengthUnit();
        double atX = (at.x - mesh.origin().x()) / unit;
        double atY = (at.y - mesh.origin().y()) / unit;
        double atZ = (at.z - mesh.origin().z()) / unit;
        longestFound = 0;
        search(atX, atY, atZ, 0, irradiance);
        irradiance.scale(mesh.powerUnit() / unit / unit);
        if (rays != null) {
            double around = longestFound > 0 ? longestFound : mesh.largestExtent();
            search(atX, atY, atZ, AROUND * around, null);
            irradiance.add(rays.sum());
        }
    }

    /**
     * Looks at the triangles that the point is in; or, if it is to look around, at the others that are not farther than that.
     *
     * @param around in units of length; 0 for the triangles that the point is in
     * @param sum of their densities; null if it looks around
     */
    private void search(double atX, double atY, double atZ, double around, Rgb sum) {
        int receiver = point.object << 1 | (point.front ? 1 : 0);
        double cosine = PhotonFilter.TWO_SIDED_NORMAL.cosine();
        BoxTree tree = mesh.tree;
        start(point, atX, atY, atZ, around);
        for (int leaf = tree.next(walk); leaf != BoxTree.DONE; leaf = tree.next(walk)) {
            x = atX - tree.middle(leaf, 0);
            y = atY - tree.middle(leaf, 1);
            z = atZ - tree.middle(leaf, 2);
            int end = tree.end(leaf);
            for (int i = tree.first(leaf); i < end; i++) {
                if (mesh.tags[2 * i + 1] == receiver
                        && PackedNormal.isWithin(
                                mesh.tags[2 * i], cosine, point.normalX, point.normalY, point.normalZ)) {
                    add(i, sum);
                }
            }
        }
    }

    /** Walks along the line through the point and its normal: however large triangles are, they are not missed. */
    private void start(SurfacePoint at, double atX, double atY, double atZ, double around) {
        boolean steep = Math.abs(at.normalX) > Math.abs(at.normalZ);
        double ux = steep ? -at.normalY : 0;
        double uy = steep ? at.normalX : -at.normalZ;
        double uz = steep ? 0 : at.normalY;
        double vx = at.normalY * uz - at.normalZ * uy;
        double vy = at.normalZ * ux - at.normalX * uz;
        double vz = at.normalX * uy - at.normalY * ux;
        double all = Double.POSITIVE_INFINITY;
        walk.box(-all, -all, -all, all, all, all);
        double rounding =
                around + FootprintRegion.ROUNDING * Math.max(Math.abs(atX), Math.max(Math.abs(atY), Math.abs(atZ)));
        cutBothSides(ux, uy, uz, ux * atX + uy * atY + uz * atZ, rounding);
        cutBothSides(vx, vy, vz, vx * atX + vy * atY + vz * atZ, rounding);
        mesh.tree.start(walk);
    }

    private void cutBothSides(double nx, double ny, double nz, double along, double rounding) {
        double margin = rounding * (Math.abs(nx) + Math.abs(ny) + Math.abs(nz));
        walk.cut(nx, ny, nz, -along, margin);
        walk.cut(-nx, -ny, -nz, along, margin);
    }

    /**
     * Adds the density of a cell, if its triangle has the point: in units of power and length, or that of a ray; or, if there is no
     * sum, the ray of a cell whose triangle does not have it.
     */
    private void add(int cell, Rgb sum) {
        int i = CausticMesh.NUMBERS * cell;
        float[] n = mesh.numbers;
        bx = (double) n[i + 3] - n[i];
        by = (double) n[i + 4] - n[i + 1];
        bz = (double) n[i + 5] - n[i + 2];
        cx = (double) n[i + 6] - n[i];
        cy = (double) n[i + 7] - n[i + 1];
        cz = (double) n[i + 8] - n[i + 2];
        normalX = by * cz - bz * cy;
        normalY = bz * cx - bx * cz;
        normalZ = bx * cy - by * cx;
        double squared = normalX * normalX + normalY * normalY + normalZ * normalZ;
        boolean isWanted = squared > 0 && isInside(i) == (sum != null);
        double longestSquared = isWanted ? longestSquared() : 0;
        double off = normalX * (x - n[i]) + normalY * (y - n[i + 1]) + normalZ * (z - n[i + 2]);
        if (!isWanted || !(off * off <= DEPTH_SQUARED * longestSquared * squared)) {
            return;
        }
        if (sum == null) {
            used += addRay(cell, squared, Math.sqrt(longestSquared), true) ? 1 : 0;
            return;
        }
        if (rays == null || !addRay(cell, squared, Math.sqrt(longestSquared), false)) {
            double density = 2 / Math.sqrt(squared);
            sum.add(density * n[i + 9], density * n[i + 10], density * n[i + 11]);
        }
        longestFound = Math.max(longestFound, Math.sqrt(longestSquared));
        used++;
    }

    /** The square of the triangle's longest edge. */
    private double longestSquared() {
        double dx = cx - bx;
        double dy = cy - by;
        double dz = cz - bz;
        return Math.max(
                dx * dx + dy * dy + dz * dz, Math.max(bx * bx + by * by + bz * bz, cx * cx + cy * cy + cz * cz));
    }

    private boolean isInside(int i) {
        return isInside(i, bx, by, bz) && isInside(i + 6, -cx, -cy, -cz) && isInside(i + 3, cx - bx, cy - by, cz - bz);
    }

    /** Adds the ray of a cell that lands at the point; false if there is none. */
    private boolean addRay(int cell, double squared, double longest, boolean isBeside) {
        int i = CausticMesh.NUMBERS * cell;
        double dx = x - mesh.numbers[i];
        double dy = y - mesh.numbers[i + 1];
        double dz = z - mesh.numbers[i + 2];
        double s = normalX * (dy * cz - dz * cy) + normalY * (dz * cx - dx * cz) + normalZ * (dx * cy - dy * cx);
        double t = normalX * (by * dz - bz * dy) + normalY * (bz * dx - bx * dz) + normalZ * (bx * dy - by * dx);
        double orientation = normalX * point.normalX + normalY * point.normalY + normalZ * point.normalZ;
        double depth = DEPTH * longest * mesh.lengthUnit();
        return isBeside
                ? rays.addBeside(cell, s / squared, t / squared, orientation, depth)
                : rays.add(cell, s / squared, t / squared, orientation, depth);
    }

    /** Whether the point is on the inner side of the edge that leaves the vertex at a place. */
    private boolean isInside(int vertex, double ex, double ey, double ez) {
        double inX = normalY * ez - normalZ * ey;
        double inY = normalZ * ex - normalX * ez;
        double inZ = normalX * ey - normalY * ex;
        float[] n = mesh.numbers;
        double distance = inX * (x - n[vertex]) + inY * (y - n[vertex + 1]) + inZ * (z - n[vertex + 2]);
        return distance > 0 || distance == 0 && FootprintSides.isFirst(inX, inY, inZ);
    }

    long examined() {
        return walk.examined();
    }

    long used() {
        return used;
    }
}
