package org.diacaustic.trial;

import org.diacaustic.map.Estimator;
import org.diacaustic.map.PhotonFilter;
import org.diacaustic.map.PhotonMap;
import org.diacaustic.map.PhotonSlice;
import org.diacaustic.map.PhotonStore;
import org.diacaustic.map.PhotonTree;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;

/** Photons that a trial puts where it wants them, all of the same power, in the store that a forward pass fills. */
final class StoredPhotons {
    private final PhotonStore store;
    private final PhotonSlice slice;
    private final Rgb power;

    /**
     * @param origin the middle of what is lit
     * @param extent how far that reaches, positive
     * @param capacity the most photons that may be stored
     * @param power of a photon, in W
     */
    StoredPhotons(Vector3 origin, double extent, int capacity, double power) {
        this.store =
                new PhotonStore(origin, Arithmetic.powerOfTwoNear(extent), Arithmetic.powerOfTwoNear(power), capacity);
        this.slice = store.slice();
        this.power = new Rgb().set(power, power, power);
    }

    StoredPhotons add(SurfacePoint at) {
        return add(at, power);
    }

    StoredPhotons add(SurfacePoint at, Rgb photonPower) {
        slice.add(at, photonPower);
        return this;
    }

    /** How many were stored and how many left out; nothing may be added afterwards. */
    PhotonStore store() {
        store.append(slice);
        return store;
    }

    PhotonTree tree() {
        return PhotonTree.movedFrom(store(), new Workers(1));
    }

    /** What a new reader of a map finds, in W·m⁻². */
    static double irradiance(PhotonTree tree, Estimator estimator, PhotonFilter filter, SurfacePoint at) {
        Rgb irradiance = new Rgb();
        PhotonMap.over(tree, estimator, filter).lookup().irradiance(at, irradiance);
        return irradiance.green;
    }

    /** A point of a surface, on its outer side. */
    static SurfacePoint point(double x, double y, double z, double normalX, double normalY, double normalZ) {
        SurfacePoint point = new SurfacePoint();
        point.x = x;
        point.y = y;
        point.z = z;
        point.normalX = normalX;
        point.normalY = normalY;
        point.normalZ = normalZ;
        point.front = true;
        return point;
    }

    /** A point of a floor at height 0. */
    static SurfacePoint floor(double x, double z) {
        return point(x, 0, z, 0, 1, 0);
    }
}
