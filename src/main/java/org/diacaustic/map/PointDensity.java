package org.diacaustic.map;

import org.diacaustic.index.BoxTree;
import org.diacaustic.index.BoxWalk;
import org.diacaustic.math.Rgb;

/**
 * Finds the density of a mesh's light at points. A triangle counts if the point, moved along the triangle's normal, is in it,
 * and is not farther off than a quarter of its longest edge: so far the chord of a third of a circle is from its arc.
 * Working storage of one task.
 */
final class PointDensity {
    /** The square of the largest depth, in parts of the longest edge. */
    private static final double DEPTH_SQUARED = 0.0625;

    private final CausticMesh mesh;
    private final BoxWalk walk = new BoxWalk();
    private long used;

    /** Where is asked, from the middle of a leaf, in units of length. */
    private double x;

    private double y;
    private double z;

    /** The normal of a triangle: its length is twice the area. */
    private double normalX;

    private double normalY;
    private double normalZ;

    PointDensity(CausticMesh mesh) {
        this.mesh = mesh;
    }

    void find(SurfacePoint at, Rgb irradiance) {
        if (!PhotonSearch.canStart(at)) {
            irradiance.set(Double.NaN, Double.NaN, Double.NaN);
            return;
        }
        irradiance.set(0, 0, 0);
        double unit = mesh.lengthUnit();
        double atX = (at.x - mesh.origin().x()) / unit;
        double atY = (at.y - mesh.origin().y()) / unit;
        double atZ = (at.z - mesh.origin().z()) / unit;
        int receiver = at.object << 1 | (at.front ? 1 : 0);
        double cosine = PhotonFilter.TWO_SIDED_NORMAL.cosine();
        BoxTree tree = mesh.tree;
        start(at, atX, atY, atZ);
        for (int leaf = tree.next(walk); leaf != BoxTree.DONE; leaf = tree.next(walk)) {
            x = atX - tree.middle(leaf, 0);
            y = atY - tree.middle(leaf, 1);
            z = atZ - tree.middle(leaf, 2);
            int end = tree.end(leaf);
            for (int i = tree.first(leaf); i < end; i++) {
                if (mesh.tags[2 * i + 1] == receiver
                        && PackedNormal.isWithin(mesh.tags[2 * i], cosine, at.normalX, at.normalY, at.normalZ)) {
                    add(CausticMesh.NUMBERS * i, irradiance);
                }
            }
        }
        irradiance.scale(mesh.powerUnit() / unit / unit);
    }

    /** Walks along the line through the point and its normal: however large triangles are, they are not missed. */
    private void start(SurfacePoint at, double atX, double atY, double atZ) {
        boolean steep = Math.abs(at.normalX) > Math.abs(at.normalZ);
        double ux = steep ? -at.normalY : 0;
        double uy = steep ? at.normalX : -at.normalZ;
        double uz = steep ? 0 : at.normalY;
        double vx = at.normalY * uz - at.normalZ * uy;
        double vy = at.normalZ * ux - at.normalX * uz;
        double vz = at.normalX * uy - at.normalY * ux;
        double all = Double.POSITIVE_INFINITY;
        walk.box(-all, -all, -all, all, all, all);
        double rounding = FootprintRegion.ROUNDING * Math.max(Math.abs(atX), Math.max(Math.abs(atY), Math.abs(atZ)));
        cutBothSides(ux, uy, uz, ux * atX + uy * atY + uz * atZ, rounding);
        cutBothSides(vx, vy, vz, vx * atX + vy * atY + vz * atZ, rounding);
        mesh.tree.start(walk);
    }

    private void cutBothSides(double nx, double ny, double nz, double along, double rounding) {
        double margin = rounding * (Math.abs(nx) + Math.abs(ny) + Math.abs(nz));
        walk.cut(nx, ny, nz, -along, margin);
        walk.cut(-nx, -ny, -nz, along, margin);
    }

    /** Adds the density of a triangle whose numbers begin at a place, in units of power and length. */
    private void add(int i, Rgb sum) {
        float[] n = mesh.numbers;
        double bx = (double) n[i + 3] - n[i];
        double by = (double) n[i + 4] - n[i + 1];
        double bz = (double) n[i + 5] - n[i + 2];
        double cx = (double) n[i + 6] - n[i];
        double cy = (double) n[i + 7] - n[i + 1];
        double cz = (double) n[i + 8] - n[i + 2];
        normalX = by * cz - bz * cy;
        normalY = bz * cx - bx * cz;
        normalZ = bx * cy - by * cx;
        double squared = normalX * normalX + normalY * normalY + normalZ * normalZ;
        if (squared > 0
                && isInside(i, bx, by, bz)
                && isInside(i + 6, -cx, -cy, -cz)
                && isInside(i + 3, cx - bx, cy - by, cz - bz)) {
            double off = normalX * (x - n[i]) + normalY * (y - n[i + 1]) + normalZ * (z - n[i + 2]);
            double dx = cx - bx;
            double dy = cy - by;
            double dz = cz - bz;
            double longestSquared = Math.max(
                    dx * dx + dy * dy + dz * dz, Math.max(bx * bx + by * by + bz * bz, cx * cx + cy * cy + cz * cz));
            if (off * off <= DEPTH_SQUARED * longestSquared * squared) {
                double density = 2 / Math.sqrt(squared);
                sum.add(density * n[i + 9], density * n[i + 10], density * n[i + 11]);
                used++;
            }
        }
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
