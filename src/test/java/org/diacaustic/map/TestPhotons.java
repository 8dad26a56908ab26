package org.diacaustic.map;

import java.util.SplittableRandom;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;

/** Photons on simple surfaces, each of the same power, and what maps find there. */
final class TestPhotons {
    static final Workers ONE = new Workers(1);

    private final PhotonStore store = new PhotonStore(Vector3.ZERO, 1, 10_000_000);
    private final PhotonSlice slice = store.slice();
    private final Rgb power = new Rgb();

    /** Adds a photon of power (p, p/2, 0). */
    TestPhotons add(SurfacePoint point, double p) {
        slice.add(point, power.set(p, p / 2, 0));
        return this;
    }

    /** Adds photons that come to 1 W·m⁻² on the plane z = 0, within |x| and |y| ≤ half; they face up, or down. */
    TestPhotons floor(SplittableRandom random, int count, double half, boolean up) {
        for (int i = 0; i < count; i++) {
            add(
                    floorPoint(random.nextDouble(-half, half), random.nextDouble(-half, half), up),
                    4 * half * half / count);
        }
        return this;
    }

    static SurfacePoint floorPoint(double x, double y, boolean up) {
        return point(x, y, 0, 0, 0, up ? 1 : -1);
    }

    /** A point that faces up, anywhere. */
    static SurfacePoint above(double x, double y, double z) {
        return point(x, y, z, 0, 0, 1);
    }

    static SurfacePoint point(double x, double y, double z, double normalX, double normalY, double normalZ) {
        SurfacePoint point = new SurfacePoint();
        point.x = x;
        point.y = y;
        point.z = z;
        point.normalX = normalX;
        point.normalY = normalY;
        point.normalZ = normalZ;
        return point;
    }

    PhotonTree tree() {
        return tree(ONE);
    }

    PhotonTree tree(Workers workers) {
        store.append(slice);
        return PhotonTree.movedFrom(store, workers);
    }

    PhotonStore store() {
        store.append(slice);
        return store;
    }

    /** The red irradiance that a new reader finds. */
    static double red(PhotonMap map, SurfacePoint point) {
        Rgb irradiance = new Rgb();
        map.lookup().irradiance(point, irradiance);
        return irradiance.red;
    }

    /** Mean and its standard error. */
    record Mean(double value, double error) {
        static Mean of(double[] values) {
            double sum = 0;
            for (double value : values) {
                sum += value;
            }
            double mean = sum / values.length;
            double squares = 0;
            for (double value : values) {
                squares += (value - mean) * (value - mean);
            }
            return new Mean(mean, Math.sqrt(squares / (values.length - 1) / values.length));
        }
    }
}
