package org.diacaustic.map;

import org.diacaustic.index.BoxTree;
import org.diacaustic.index.BoxWalk;
import org.diacaustic.math.Vector3;

/**
 * A footprint in the coordinates of a mesh: goes through the leaves that it touches, and tells which part of a cell is in it.
 * Working storage of one task.
 */
final class FootprintRegion {
    /**
     * What rounding in boxes may move, in parts of the largest coordinate of what is asked about. It makes regions touch more
     * boxes, and slabs thicker; it does not move what cuts the cells.
     */
    static final double ROUNDING = 0x1p-20;

    /** Of the offsets of cells, in parts of the width of their leaf's box. */
    private static final double OFFSET_ROUNDING = 0x1p-24;

    /** Packed normals are off by half of this: light that may face the eye is taken to. */
    private static final double GRAZING = 0x1p-12;

    private static final double THIRD = 1.0 / 3;
    private static final double COSINE = PhotonFilter.TWO_SIDED_NORMAL.cosine();

    private final CausticMesh mesh;
    private final BoxWalk walk = new BoxWalk();
    private final TriangleClip clip = new TriangleClip();
    private Footprint footprint;
    private FootprintSides sides;

    /** For each side, the point of it that is kept, in units of length from the mesh's origin. */
    private final double[] middles = new double[3 * Footprint.LARGEST_CORNERS];

    /** For each side, the middle of the leaf from there. */
    private final double[] atLeaf = new double[3 * Footprint.LARGEST_CORNERS];

    /** The sides that may cut the leaf, as bits. */
    private int cutting;

    /** Light is where the polygon's normal · x is no farther from the middle than half the width. */
    private double slabMiddle;

    private double slabHalf;

    /** The leaf's middle, from that of the slab; and what rounding may move its cells, which are kept as offsets from it. */
    private double slabAtLeaf;

    private double slabRounding;

    /** Neighbours often have the same normal, which need not be asked again. */
    private int lastNormal;

    private boolean lastAccepted;

    /** The middle of the leaf, and the eye, in units of length from the mesh's origin. */
    private double leafX;

    private double leafY;
    private double leafZ;
    private double eyeX;
    private double eyeY;
    private double eyeZ;

    /** The weights of second and third vertex at the middle of the part that was found last. */
    private double middleU;

    private double middleV;
    private final SurfacePoint facing = new SurfacePoint();

    /** What rounding in boxes may move near the footprint, in units of length. */
    private double rounding;

    FootprintRegion(CausticMesh mesh) {
        this.mesh = mesh;
    }

    /** Begins the walk through what a closed footprint touches. */
    void start(Footprint closed) {
        footprint = closed;
        sides = closed.sides;
        lastNormal = PackedNormal.MIXED;
        double inverseUnit = 1 / mesh.lengthUnit();
        bound(inverseUnit);
        Vector3 origin = mesh.origin();
        eyeX = inverseUnit * (closed.eyeX - origin.x());
        eyeY = inverseUnit * (closed.eyeY - origin.y());
        eyeZ = inverseUnit * (closed.eyeZ - origin.z());
        for (int side = 0; side < sides.count; side++) {
            int i = 3 * side;
            double nx = sides.normals[i];
            double ny = sides.normals[i + 1];
            double nz = sides.normals[i + 2];
            middles[i] = inverseUnit * (sides.middles[i] - origin.x());
            middles[i + 1] = inverseUnit * (sides.middles[i + 1] - origin.y());
            middles[i + 2] = inverseUnit * (sides.middles[i + 2] - origin.z());
            double c = -(nx * middles[i] + ny * middles[i + 1] + nz * middles[i + 2]);
            walk.cut(nx, ny, nz, c, rounding(nx, ny, nz));
        }
        double nx = closed.polygonX;
        double ny = closed.polygonY;
        double nz = closed.polygonZ;
        slabMiddle = inverseUnit
                * (nx * (closed.centreX - origin.x())
                        + ny * (closed.centreY - origin.y())
                        + nz * (closed.centreZ - origin.z()));
        slabHalf = closed.thickness * inverseUnit + rounding(nx, ny, nz);
        mesh.tree.start(walk);
    }

    private double rounding(double nx, double ny, double nz) {
        return rounding * (Math.abs(nx) + Math.abs(ny) + Math.abs(nz));
    }

    /** Sets the box of the walk: around the corners, and as far along the eye's rays as light may be. */
    private void bound(double inverseUnit) {
        double lowX = Double.POSITIVE_INFINITY;
        double lowY = Double.POSITIVE_INFINITY;
        double lowZ = Double.POSITIVE_INFINITY;
        double highX = Double.NEGATIVE_INFINITY;
        double highY = Double.NEGATIVE_INFINITY;
        double highZ = Double.NEGATIVE_INFINITY;
        for (int corner = 0; corner < footprint.cornerCount(); corner++) {
            int i = 3 * corner;
            double travel = footprint.travel(corner);
            double x = footprint.corners[i] - mesh.origin().x();
            double y = footprint.corners[i + 1] - mesh.origin().y();
            double z = footprint.corners[i + 2] - mesh.origin().z();
            // Not a number if the eye looks straight along an axis and there is no limit: a box without this bound.
            double dx = travel * Math.abs(footprint.directions[i]);
            double dy = travel * Math.abs(footprint.directions[i + 1]);
            double dz = travel * Math.abs(footprint.directions[i + 2]);
            lowX = Math.min(lowX, x - dx);
            lowY = Math.min(lowY, y - dy);
            lowZ = Math.min(lowZ, z - dz);
            highX = Math.max(highX, x + dx);
            highY = Math.max(highY, y + dy);
            highZ = Math.max(highZ, z + dz);
        }
        double farthest = Math.max(Math.max(Math.max(-lowX, highX), Math.max(-lowY, highY)), Math.max(-lowZ, highZ));
        // Of a region without end only the mesh's own size is known.
        rounding = ROUNDING * (farthest < Double.POSITIVE_INFINITY ? farthest * inverseUnit : 1);
        walk.box(
                lowX * inverseUnit - rounding,
                lowY * inverseUnit - rounding,
                lowZ * inverseUnit - rounding,
                highX * inverseUnit + rounding,
                highY * inverseUnit + rounding,
                highZ * inverseUnit + rounding);
    }

    /** The next leaf that the footprint touches, or {@link BoxTree#DONE}. */
    int next() {
        BoxTree tree = mesh.tree;
        int leaf = tree.next(walk);
        if (leaf != BoxTree.DONE) {
            cutting = walk.cutting();
            double x = tree.middle(leaf, 0);
            double y = tree.middle(leaf, 1);
            double z = tree.middle(leaf, 2);
            leafX = x;
            leafY = y;
            leafZ = z;
            for (int left = cutting; left != 0; left &= left - 1) {
                int i = 3 * Integer.numberOfTrailingZeros(left);
                atLeaf[i] = x - middles[i];
                atLeaf[i + 1] = y - middles[i + 1];
                atLeaf[i + 2] = z - middles[i + 2];
            }
            double nx = footprint.polygonX;
            double ny = footprint.polygonY;
            double nz = footprint.polygonZ;
            slabAtLeaf = nx * x + ny * y + nz * z - slabMiddle;
            slabRounding = OFFSET_ROUNDING
                    * (Math.abs(nx) * tree.width(leaf, 0)
                            + Math.abs(ny) * tree.width(leaf, 1)
                            + Math.abs(nz) * tree.width(leaf, 2));
        }
        return leaf;
    }

    /** The part of a cell of the last leaf that is in the footprint: 0 if it is not on its surface. */
    double fraction(int cell) {
        middleU = THIRD;
        middleV = THIRD;
        if (mesh.tags[2 * cell + 1] != footprint.receiver || !accepts(mesh.tags[2 * cell])) {
            return 0;
        }
        double fraction = cutting == 0 ? 1 : fractionBetweenSides(cell);
        return fraction > 0 && slabHalf < Double.POSITIVE_INFINITY && !reaches(cell) ? 0 : fraction;
    }

    /** Whether light with this normal is on the same part of the surface, and the eye sees it. */
    private boolean accepts(int normal) {
        if (normal != lastNormal) {
            lastNormal = normal;
            Footprint f = footprint;
            lastAccepted = PackedNormal.isWithin(normal, COSINE, f.normalX, f.normalY, f.normalZ)
                    && !PackedNormal.isWithin(normal, GRAZING, f.directionX, f.directionY, f.directionZ);
        }
        return lastAccepted;
    }

    private double fractionBetweenSides(int cell) {
        float[] numbers = mesh.numbers;
        int i = CausticMesh.NUMBERS * cell;
        double ax = numbers[i];
        double ay = numbers[i + 1];
        double az = numbers[i + 2];
        double bx = numbers[i + 3];
        double by = numbers[i + 4];
        double bz = numbers[i + 5];
        double cx = numbers[i + 6];
        double cy = numbers[i + 7];
        double cz = numbers[i + 8];
        clip.begin();
        for (int left = cutting; left != 0; left &= left - 1) {
            int side = Integer.numberOfTrailingZeros(left);
            int k = 3 * side;
            double nx = sides.normals[k];
            double ny = sides.normals[k + 1];
            double nz = sides.normals[k + 2];
            double x = atLeaf[k];
            double y = atLeaf[k + 1];
            double z = atLeaf[k + 2];
            // Distances from a point of the edge, so that what lies on an edge along an axis is at exactly 0.
            double first = nx * (ax + x) + ny * (ay + y) + nz * (az + z);
            double second = nx * (bx + x) + ny * (by + y) + nz * (bz + z);
            double third = nx * (cx + x) + ny * (cy + y) + nz * (cz + z);
            clip.add(first, second, third, sides.holdsPlane[side]);
        }
        double fraction = clip.fraction();
        middleU = clip.middleU();
        middleV = clip.middleV();
        return fraction;
    }

    /** How large a unit of area is in the picture, in units of length, at the middle of the part that was found last. */
    double pictureDensity(int cell) {
        float[] n = mesh.numbers;
        int i = CausticMesh.NUMBERS * cell;
        double first = 1 - middleU - middleV;
        double x = leafX + first * n[i] + middleU * n[i + 3] + middleV * n[i + 6] - eyeX;
        double y = leafY + first * n[i + 1] + middleU * n[i + 4] + middleV * n[i + 7] - eyeY;
        double z = leafZ + first * n[i + 2] + middleU * n[i + 5] + middleV * n[i + 8] - eyeZ;
        Vector3 forward = footprint.eyeForward;
        double depth = x * forward.x() + y * forward.y() + z * forward.z();
        double along;
        if (footprint.isFlat()) {
            along = x * footprint.normalX + y * footprint.normalY + z * footprint.normalZ;
        } else {
            PackedNormal.unpack(mesh.tags[2 * cell], facing);
            along = x * facing.normalX + y * facing.normalY + z * facing.normalZ;
        }
        return depth > 0 ? Math.abs(along) / (depth * depth * depth) : 0;
    }

    /** Whether a triangle comes as near to the polygon's plane as the footprint reaches. */
    private boolean reaches(int cell) {
        double first = slabAtLeaf + alongPolygonNormal(cell, 0);
        double second = slabAtLeaf + alongPolygonNormal(cell, 3);
        double third = slabAtLeaf + alongPolygonNormal(cell, 6);
        double half = slabHalf + slabRounding;
        return (first <= half || second <= half || third <= half)
                && (first >= -half || second >= -half || third >= -half);
    }

    private double alongPolygonNormal(int cell, int vertex) {
        int i = CausticMesh.NUMBERS * cell + vertex;
        return footprint.polygonX * mesh.numbers[i]
                + footprint.polygonY * mesh.numbers[i + 1]
                + footprint.polygonZ * mesh.numbers[i + 2];
    }

    /** Inner nodes and cells looked at so far. */
    long examined() {
        return walk.examined();
    }
}
