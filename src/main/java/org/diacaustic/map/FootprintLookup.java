package org.diacaustic.map;

import org.diacaustic.index.BoxTree;
import org.diacaustic.index.BoxWalk;
import org.diacaustic.math.Rgb;

/** Asks a {@link CausticMesh}. Owned by one task; nothing is allocated by a lookup. */
public final class FootprintLookup implements IlluminationMap.Lookup {
    /** What rounding in the mesh may move, in units of length: lit places are at most about two units from the origin. */
    static final double ROUNDING = 0x1p-21;

    /** Packed normals are off by half of this: light that may face the eye is taken to. */
    private static final double GRAZING = 0x1p-12;

    private final CausticMesh mesh;
    private final PointDensity density;
    private final BoxWalk walk = new BoxWalk();
    private final TriangleClip clip = new TriangleClip();

    /** Four numbers a plane: n and c of n · x + c, with x in units of length from the mesh's origin. */
    private final double[] planes = new double[4 * Footprint.LARGEST_CORNERS];

    /** For each plane, n · x + c at the middle of a leaf. */
    private final double[] atMiddle = new double[Footprint.LARGEST_CORNERS];

    private Footprint footprint;

    /** The footprint's slab: n · x is within [low, high]. */
    private double slabLow;

    private double slabHigh;

    /** Neighbours often have the same normal, which need not be asked again. */
    private int lastNormal;

    private boolean lastAccepted;
    private long used;

    FootprintLookup(CausticMesh mesh) {
        this.mesh = mesh;
        this.density = new PointDensity(mesh);
    }

    /**
     * Sets the density of light at the point, in W·m⁻²: power over area, summed over all triangles that the point is in. It is
     * exact for the mesh, but near folds of the light the mean over even a small footprint is another, for there the density
     * is very uneven. Points of power are left out. Not a number where it is asked with what is not finite.
     */
    @Override
    public void irradiance(SurfacePoint at, Rgb irradiance) {
        density.find(at, irradiance);
    }

    /**
     * {@inheritDoc}
     *
     * @throws IllegalStateException if the footprint is not closed
     */
    @Override
    public void irradiance(Footprint within, SurfacePoint at, Rgb irradiance) {
        if (!within.isClosed()) {
            throw new IllegalStateException("a footprint must be closed before a map is asked about it");
        }
        start(within);
        double red = 0;
        double green = 0;
        double blue = 0;
        BoxTree tree = mesh.tree;
        float[] numbers = mesh.numbers;
        int[] tags = mesh.tags;
        for (int leaf = tree.next(walk); leaf != BoxTree.DONE; leaf = tree.next(walk)) {
            double x = tree.middle(leaf, 0);
            double y = tree.middle(leaf, 1);
            double z = tree.middle(leaf, 2);
            for (int k = 0; k < footprint.planeCount; k++) {
                atMiddle[k] = planes[4 * k] * x + planes[4 * k + 1] * y + planes[4 * k + 2] * z + planes[4 * k + 3];
            }
            double slab = footprint.polygonX * x + footprint.polygonY * y + footprint.polygonZ * z;
            int end = tree.end(leaf);
            for (int i = tree.first(leaf); i < end; i++) {
                if (tags[2 * i + 1] == footprint.receiver && accepts(tags[2 * i]) && isInSlab(i, slab)) {
                    double fraction = fraction(i);
                    if (fraction > 0) {
                        int place = CausticMesh.NUMBERS * i;
                        red += fraction * numbers[place + 9];
                        green += fraction * numbers[place + 10];
                        blue += fraction * numbers[place + 11];
                        used++;
                    }
                }
            }
        }
        double scale = mesh.powerUnit() / footprint.area();
        irradiance.set(red * scale, green * scale, blue * scale);
    }

    /** Moves the footprint into the mesh's coordinates, and begins to walk. */
    private void start(Footprint within) {
        footprint = within;
        lastNormal = PackedNormal.MIXED;
        double inverseUnit = 1 / mesh.lengthUnit();
        bound(inverseUnit);
        double x = mesh.origin().x();
        double y = mesh.origin().y();
        double z = mesh.origin().z();
        for (int k = 0; k < footprint.planeCount; k++) {
            int i = 3 * k;
            double nx = footprint.normals[i];
            double ny = footprint.normals[i + 1];
            double nz = footprint.normals[i + 2];
            double c = -inverseUnit
                    * (nx * (footprint.middles[i] - x)
                            + ny * (footprint.middles[i + 1] - y)
                            + nz * (footprint.middles[i + 2] - z));
            planes[4 * k] = nx;
            planes[4 * k + 1] = ny;
            planes[4 * k + 2] = nz;
            planes[4 * k + 3] = c;
            walk.cut(nx, ny, nz, c + ROUNDING * (Math.abs(nx) + Math.abs(ny) + Math.abs(nz)));
        }
        double nx = footprint.polygonX;
        double ny = footprint.polygonY;
        double nz = footprint.polygonZ;
        double middle = inverseUnit
                * (nx * (footprint.centreX - x) + ny * (footprint.centreY - y) + nz * (footprint.centreZ - z));
        double half = footprint.thickness * inverseUnit + ROUNDING * (Math.abs(nx) + Math.abs(ny) + Math.abs(nz));
        slabLow = middle - half;
        slabHigh = middle + half;
        mesh.tree.start(walk);
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
        walk.box(
                lowX * inverseUnit - ROUNDING,
                lowY * inverseUnit - ROUNDING,
                lowZ * inverseUnit - ROUNDING,
                highX * inverseUnit + ROUNDING,
                highY * inverseUnit + ROUNDING,
                highZ * inverseUnit + ROUNDING);
    }

    /** Whether light with this normal is on the same part of the surface, and the eye sees it. */
    private boolean accepts(int normal) {
        if (normal != lastNormal) {
            lastNormal = normal;
            Footprint f = footprint;
            double cosine = PhotonFilter.TWO_SIDED_NORMAL.cosine();
            lastAccepted = PackedNormal.isWithin(normal, cosine, f.normalX, f.normalY, f.normalZ)
                    && !PackedNormal.isWithin(normal, GRAZING, f.directionX, f.directionY, f.directionZ);
        }
        return lastAccepted;
    }

    /** Whether a triangle comes as near to the polygon as the footprint reaches. */
    private boolean isInSlab(int cell, double atLeaf) {
        double first = atLeaf + alongPolygonNormal(cell, 0);
        double second = atLeaf + alongPolygonNormal(cell, 3);
        double third = atLeaf + alongPolygonNormal(cell, 6);
        // Without a limit, or with one that is not a number, everything is.
        return !(Math.max(first, Math.max(second, third)) < slabLow)
                && !(Math.min(first, Math.min(second, third)) > slabHigh);
    }

    private double alongPolygonNormal(int cell, int vertex) {
        int i = CausticMesh.NUMBERS * cell + vertex;
        return footprint.polygonX * mesh.numbers[i]
                + footprint.polygonY * mesh.numbers[i + 1]
                + footprint.polygonZ * mesh.numbers[i + 2];
    }

    /** The part of a triangle that is in the footprint. */
    private double fraction(int cell) {
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
        for (int k = 0; k < footprint.planeCount; k++) {
            double nx = planes[4 * k];
            double ny = planes[4 * k + 1];
            double nz = planes[4 * k + 2];
            double c = atMiddle[k];
            double first = nx * ax + ny * ay + nz * az + c;
            double second = nx * bx + ny * by + nz * bz + c;
            double third = nx * cx + ny * cy + nz * cz + c;
            double highest = Math.max(first, Math.max(second, third));
            if (highest < 0 || highest == 0 && !footprint.holdsPlane[k]) {
                return 0;
            }
            if (Math.min(first, Math.min(second, third)) < 0) {
                clip.add(first, second, third);
            }
        }
        return clip.fraction();
    }

    @Override
    public long nodesExamined() {
        return walk.examined() + density.examined();
    }

    @Override
    public long photonsUsed() {
        return used + density.used();
    }
}
