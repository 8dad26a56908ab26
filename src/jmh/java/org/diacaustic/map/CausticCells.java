package org.diacaustic.map;

import java.util.ArrayList;
import java.util.List;
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

    /** Pixels whose corners lie on one object, row by row, from some of the rows of a picture. */
    static List<Pixel> pixels(int side) {
        List<Pixel> pixels = new ArrayList<>();
        int rows = Math.max(1, side * side / 20_000);
        for (int row = 0; row < side; row += rows) {
            for (int column = 0; column < side; column++) {
                Pixel pixel = pixel(side, column, row);
                if (pixel != null) {
                    pixels.add(pixel);
                }
            }
        }
        return pixels;
    }

    private static Pixel pixel(int side, int column, int row) {
        SurfacePoint at = new SurfacePoint();
        double[] rays = new double[24];
        if (!see(at, (column + 0.5) / side, (row + 0.5) / side, rays, 0)) {
            return null;
        }
        SurfacePoint corner = new SurfacePoint();
        int[] steps = {0, 0, 1, 1, 0};
        for (int i = 0; i < 4; i++) {
            double u = (double) (column + steps[i]) / side;
            double v = (double) (row + steps[i + 1]) / side;
            if (!see(corner, u, v, rays, 6 * i) || corner.object != at.object) {
                return null;
            }
        }
        Pixel pixel = new Pixel(at, rays);
        Footprint footprint = new Footprint();
        pixel.fill(footprint);
        return footprint.close() ? pixel : null;
    }

    /** What the eye of {@link CausticPhotons#queries} sees, and how. */
    private static boolean see(SurfacePoint out, double u, double v, double[] rays, int place) {
        double dx = 0.62 * (2 * u - 1);
        double dy = -0.7071 - 0.44 * (2 * v - 1);
        double dz = -0.7071 + 0.44 * (2 * v - 1);
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        rays[place + 3] = dx / length;
        rays[place + 4] = dy / length;
        rays[place + 5] = dz / length;
        boolean lands = CausticPhotons.land(out, 0, 1.2, 2.2, rays[place + 3], rays[place + 4], rays[place + 5]);
        rays[place] = out.x;
        rays[place + 1] = out.y;
        rays[place + 2] = out.z;
        return lands;
    }

    /** What a pixel sees: a point, and place and direction of its four corners. */
    record Pixel(SurfacePoint at, double[] rays) {

        /** Light on the sphere may be off the polygon by as much as a large cell's chord is. */
        void fill(Footprint footprint) {
            footprint.begin(at);
            footprint.reach(at.object == 1 ? 0.1 : 0);
            for (int i = 0; i < rays.length; i += 6) {
                footprint.addCorner(rays[i], rays[i + 1], rays[i + 2], rays[i + 3], rays[i + 4], rays[i + 5]);
            }
        }
    }
}
