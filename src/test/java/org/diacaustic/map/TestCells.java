package org.diacaustic.map;

import java.util.SplittableRandom;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;

/** Cells of light, of power (p, p/2, 0), and footprints as an eye at a point has them. */
final class TestCells {
    private final CellStore store;
    private final CellSlice slice;
    private final Rgb power = new Rgb();

    TestCells(Vector3 origin) {
        store = new CellStore(origin, 1, 10_000_000);
        slice = store.slice();
    }

    TestCells() {
        this(Vector3.ZERO);
    }

    TestCells triangle(double p, SurfacePoint a, SurfacePoint b, SurfacePoint c) {
        slice.addTriangle(a, b, c, power.set(p, p / 2, 0));
        return this;
    }

    TestCells point(double p, SurfacePoint at) {
        slice.addPoint(at, power.set(p, p / 2, 0));
        return this;
    }

    /** Squares of a grid over |x| and |y| ≤ half, each two triangles; 1 W·m⁻² on the plane z = 0, seen from above. */
    TestCells grid(int squares, double half) {
        double step = 2 * half / squares;
        for (int row = 0; row < squares; row++) {
            for (int column = 0; column < squares; column++) {
                SurfacePoint a = floor(column * step - half, row * step - half);
                SurfacePoint b = floor((column + 1) * step - half, row * step - half);
                SurfacePoint c = floor((column + 1) * step - half, (row + 1) * step - half);
                SurfacePoint d = floor(column * step - half, (row + 1) * step - half);
                triangle(step * step / 2, a, b, c);
                triangle(step * step / 2, a, c, d);
            }
        }
        return this;
    }

    /** Triangles anywhere with |x| and |y| < 1 on the plane z = 0, each of a power that single precision holds. */
    TestCells scattered(SplittableRandom random, int count, double size) {
        for (int i = 0; i < count; i++) {
            double x = random.nextDouble(size - 1, 1 - size);
            double y = random.nextDouble(size - 1, 1 - size);
            SurfacePoint[] at = new SurfacePoint[3];
            for (int k = 0; k < 3; k++) {
                at[k] = floor(x + random.nextDouble(-size, size), y + random.nextDouble(-size, size));
            }
            triangle(1 + random.nextInt(1000), at[0], at[1], at[2]);
        }
        return this;
    }

    static SurfacePoint floor(double x, double y) {
        return TestPhotons.floorPoint(x, y, true);
    }

    static SurfacePoint floor(Vector3 at) {
        return floor(at.x(), at.y());
    }

    CausticMesh mesh() {
        return mesh(new Workers(1));
    }

    CausticMesh mesh(Workers workers) {
        return CausticMesh.movedFrom(store(), workers);
    }

    CellStore store() {
        store.append(slice);
        return store;
    }

    /** A footprint, not closed, that begins at the first of its corners. */
    static Footprint seenFrom(Vector3 eye, SurfacePoint... corners) {
        Footprint footprint = new Footprint();
        footprint.begin(corners[0]);
        for (SurfacePoint corner : corners) {
            Vector3 direction =
                    new Vector3(corner.x, corner.y, corner.z).minus(eye).normalized();
            footprint.addCorner(corner.x, corner.y, corner.z, direction.x(), direction.y(), direction.z());
        }
        return footprint;
    }

    /** The red power in a footprint, which is closed here. */
    static double powerIn(FootprintLookup lookup, Footprint footprint) {
        if (!footprint.close()) {
            throw new AssertionError("a footprint that cannot be closed");
        }
        Rgb irradiance = new Rgb();
        lookup.irradiance(footprint, new SurfacePoint(), irradiance);
        return irradiance.red * footprint.area();
    }

    /** The red density at a point. */
    static double density(CausticMesh mesh, SurfacePoint at) {
        Rgb irradiance = new Rgb();
        mesh.lookup().irradiance(at, irradiance);
        return irradiance.red;
    }
}
