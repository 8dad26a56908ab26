package org.diacaustic.map;

import java.util.Arrays;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;

/** What benchmarks of the mesh ask: the light of {@link CausticPhotons} as cells, and the pixels of an eye that sees it. */
final class CausticCells {
    private CausticCells() {}

    /** About as many triangles, of even power above the waves; light that lands apart is points of power. */
    static CellStore store(int count) {
        int side = (int) Math.round(Math.sqrt(count / 2.0));
        CellStore store = new CellStore(new Vector3(0, -1, 0), 0x1p-20, 4 * side * side);
        CellSlice slice = store.slice();
        CausticPhotons light = new CausticPhotons();
        SurfacePoint[] above = row(side);
        SurfacePoint[] below = row(side);
        boolean[] aboveLands = new boolean[side + 1];
        boolean[] belowLands = new boolean[side + 1];
        Rgb power = new Rgb().set(1, 0.9, 0.8).scale(2.0 / side / side);
        for (int row = 0; row <= side; row++) {
            SurfacePoint[] swap = above;
            above = below;
            below = swap;
            boolean[] swapLands = aboveLands;
            aboveLands = belowLands;
            belowLands = swapLands;
            for (int column = 0; column <= side; column++) {
                belowLands[column] = light.land(below[column], 2.0 * column / side - 1, 2.0 * row / side - 1);
            }
            for (int column = 0; row > 0 && column < side; column++) {
                if (aboveLands[column] && aboveLands[column + 1] && belowLands[column] && belowLands[column + 1]) {
                    add(slice, above[column], above[column + 1], below[column + 1], power);
                    add(slice, above[column], below[column + 1], below[column], power);
                }
            }
        }
        store.append(slice);
        return store;
    }

    private static SurfacePoint[] row(int side) {
        SurfacePoint[] points = new SurfacePoint[side + 1];
        for (int i = 0; i <= side; i++) {
            points[i] = new SurfacePoint();
        }
        return points;
    }

    private static void add(CellSlice slice, SurfacePoint a, SurfacePoint b, SurfacePoint c, Rgb power) {
        if (a.object == b.object && a.object == c.object) {
            slice.addTriangle(a, b, c, power);
        } else {
            slice.addPoint(a, power);
        }
    }

    /** The pixels, row by row, whose corners lie on one object. */
    static Footprint[] pixels(int side) {
        Footprint[] all = new Footprint[side * side];
        int found = 0;
        for (int row = 0; row < side; row++) {
            for (int column = 0; column < side; column++) {
                Footprint pixel = pixel(side, column, row);
                if (pixel != null) {
                    all[found++] = pixel;
                }
            }
        }
        return Arrays.copyOf(all, found);
    }

    private static Footprint pixel(int side, int column, int row) {
        Footprint pixel = new Footprint();
        SurfacePoint at = new SurfacePoint();
        if (!see(at, (column + 0.5) / side, (row + 0.5) / side, null)) {
            return null;
        }
        pixel.begin(at);
        pixel.reach(at.object == 1 ? Double.POSITIVE_INFINITY : 0);
        SurfacePoint corner = new SurfacePoint();
        int[] steps = {0, 0, 1, 1, 0};
        for (int i = 0; i < 4; i++) {
            if (!see(corner, (double) (column + steps[i]) / side, (double) (row + steps[i + 1]) / side, pixel)
                    || corner.object != at.object) {
                return null;
            }
        }
        return pixel.close() ? pixel : null;
    }

    /** What the eye of {@link CausticPhotons#queries} sees; adds it as a corner, if there is a footprint. */
    private static boolean see(SurfacePoint out, double u, double v, Footprint footprint) {
        double dx = 0.62 * (2 * u - 1);
        double dy = -0.7071 - 0.44 * (2 * v - 1);
        double dz = -0.7071 + 0.44 * (2 * v - 1);
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        dx /= length;
        dy /= length;
        dz /= length;
        boolean lands = CausticPhotons.land(out, 0, 1.2, 2.2, dx, dy, dz);
        if (footprint != null) {
            footprint.addCorner(out.x, out.y, out.z, dx, dy, dz);
        }
        return lands;
    }
}
