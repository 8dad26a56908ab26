package org.diacaustic.map;

import org.diacaustic.index.BoxTree;
import org.diacaustic.math.Rgb;

/** Asks a {@link CausticMesh}, and counts nodes and cells. Owned by one task; nothing is allocated by a lookup. */
public final class FootprintLookup implements IlluminationMap.Lookup {
    private final CausticMesh mesh;
    private final FootprintRegion region;
    private final PointDensity density;
    private long used;

    /** @param paths null if points have the density of the triangles that they are in */
    FootprintLookup(CausticMesh mesh, LightPaths paths) {
        this.mesh = mesh;
        this.region = new FootprintRegion(mesh);
        this.density = new PointDensity(mesh, paths);
    }

    /**
     * Sets the density of light at the point, in W·m⁻²: power over area, summed over all triangles that the point is in. It is
     * exact for the mesh, but where light is folded the mean over even a small footprint is another, for there the
     * density is very uneven. With {@link LightPaths}, a triangle's density is replaced by that of its ray which lands at the point, where
     * one is found. Points of power are left out. Not a number where it is asked with what is not finite.
     */
    @Override
    public void irradiance(SurfacePoint at, Rgb irradiance) {
        density.find(at, irradiance);
    }

    /**
     * Sets the mean irradiance within a footprint, in W·m⁻²: the power of every cell that is on the footprint's side of its
     * surface and faces the eye, times the part of the cell within, over the footprint's area, on the surface or in the picture.
     *
     * @param at is not read: the footprint knows its surface
     * @throws IllegalStateException if the footprint is not closed
     */
    @Override
    public void irradiance(Footprint footprint, SurfacePoint at, Rgb irradiance) {
        if (!footprint.isClosed()) {
            throw new IllegalStateException("a map can be asked about closed footprints only");
        }
        double red = 0;
        double green = 0;
        double blue = 0;
        BoxTree tree = mesh.tree;
        float[] numbers = mesh.numbers;
        boolean overPicture = footprint.eyeForward != null;
        region.start(footprint);
        for (int leaf = region.next(); leaf != BoxTree.DONE; leaf = region.next()) {
            int end = tree.end(leaf);
            for (int cell = tree.first(leaf); cell < end; cell++) {
                double fraction = region.fraction(cell);
                if (fraction > 0) {
                    fraction *= overPicture ? region.pictureDensity(cell) : 1;
                    int power = CausticMesh.NUMBERS * cell + CausticMesh.POWER;
                    red += fraction * numbers[power];
                    green += fraction * numbers[power + 1];
                    blue += fraction * numbers[power + 2];
                    used++;
                }
            }
        }
        double unit = mesh.lengthUnit();
        double scale = mesh.powerUnit() / (overPicture ? footprint.pictureArea * unit * unit : footprint.area());
        irradiance.set(red * scale, green * scale, blue * scale);
    }

    @Override
    public long nodesExamined() {
        return region.examined() + density.examined();
    }

    @Override
    public long photonsUsed() {
        return used + density.used();
    }
}
