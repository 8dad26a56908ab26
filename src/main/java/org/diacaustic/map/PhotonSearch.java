package org.diacaustic.map;

import org.diacaustic.index.PointTree;
import org.diacaustic.index.PointWalk;

/**
 * Goes through the photons of a closed ball that a filter accepts, leaf by leaf. Whoever asks may shrink the ball between
 * two leaves. Working storage of one task; nothing is allocated by a search.
 */
final class PhotonSearch {
    /** Where the photons of the last leaf are in the tree's order. */
    final int[] photons = new int[PointTree.LARGEST_LEAF];

    /** Their squared distances, in units of length. */
    final float[] distancesSquared = new float[PointTree.LARGEST_LEAF];

    private final PhotonTree tree;
    private final PointTree points;
    private final double originX;
    private final double originY;
    private final double originZ;
    private final double inverseUnit;
    private final boolean filtered;
    private final double cosine;
    private final PointWalk walk = new PointWalk();
    private float x;
    private float y;
    private float z;
    private double normalX;
    private double normalY;
    private double normalZ;

    PhotonSearch(PhotonTree tree, PhotonFilter filter) {
        this.tree = tree;
        this.points = tree.points;
        this.originX = tree.origin().x();
        this.originY = tree.origin().y();
        this.originZ = tree.origin().z();
        this.inverseUnit = 1 / tree.lengthUnit();
        this.filtered = filter != PhotonFilter.NONE;
        this.cosine = filter.cosine();
    }

    /** Whether a search can begin there: its numbers are finite. */
    static boolean canStart(SurfacePoint at) {
        return 0 * at.x + 0 * at.y + 0 * at.z + 0 * at.normalX + 0 * at.normalY + 0 * at.normalZ == 0;
    }

    /**
     * Begins at a point whose numbers are finite.
     *
     * @param radius in scene units
     */
    void start(SurfacePoint at, double radius) {
        x = (float) ((at.x - originX) * inverseUnit);
        y = (float) ((at.y - originY) * inverseUnit);
        z = (float) ((at.z - originZ) * inverseUnit);
        normalX = at.normalX;
        normalY = at.normalY;
        normalZ = at.normalZ;
        double inUnits = radius * inverseUnit;
        points.start(walk, x, y, z, (float) (inUnits * inUnits));
    }

    /** The squared radius of the ball, in units of length. */
    float radiusSquared() {
        return walk.radiusSquared;
    }

    void shrink(float radiusSquared) {
        walk.radiusSquared = radiusSquared;
    }

    /** Inner nodes and photons looked at so far, by all searches. */
    long examined() {
        return walk.examined();
    }

    /** The number of photons in the next leaf that the ball touches, which may be 0; negative if there is none left. */
    int next() {
        int leaf = points.next(walk);
        if (leaf == PointTree.DONE) {
            return PointTree.DONE;
        }
        int count = measure(points.first(leaf), points.end(leaf));
        return filtered ? filter(count) : count;
    }

    /** Notes the photons that are in the ball. */
    private int measure(int first, int end) {
        float[] xs = tree.x;
        float[] ys = tree.y;
        float[] zs = tree.z;
        float radiusSquared = walk.radiusSquared;
        int count = 0;
        for (int i = first; i < end; i++) {
            float dx = xs[i] - x;
            float dy = ys[i] - y;
            float dz = zs[i] - z;
            float distanceSquared = dx * dx + dy * dy + dz * dz;
            photons[count] = i;
            distancesSquared[count] = distanceSquared;
            count += distanceSquared <= radiusSquared ? 1 : 0;
        }
        return count;
    }

    /** Keeps those that the filter accepts. Photons of a flat surface all have one normal, which is asked once. */
    private int filter(int count) {
        int[] normals = tree.normal;
        int kept = 0;
        int last = 0;
        boolean known = false;
        boolean accepted = false;
        for (int i = 0; i < count; i++) {
            int normal = normals[photons[i]];
            if (!known || normal != last) {
                known = true;
                last = normal;
                accepted = PackedNormal.isWithin(normal, cosine, normalX, normalY, normalZ);
            }
            photons[kept] = photons[i];
            distancesSquared[kept] = distancesSquared[i];
            kept += accepted ? 1 : 0;
        }
        return kept;
    }
}
