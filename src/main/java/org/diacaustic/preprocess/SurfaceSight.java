package org.diacaustic.preprocess;

import org.diacaustic.light.Light;
import org.diacaustic.light.LightPoint;
import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Shape;

/** Aims light rays at points of one object's surface. Owned by one task. */
final class SurfaceSight {
    /** Rays flatter than this to the surface are not allowed more error than those. */
    private static final double FLATTEST = 0x1p-10;

    private final Light light;
    private final boolean isParallel;
    private final Vector3 middle;
    private final double startDistance;
    private final int object;
    private final Shape shape;
    private final Ray sight = new Ray();
    private final Rgb intensity = new Rgb();

    SurfaceSight(Beam beam, OwnMap map) {
        light = beam.light();
        isParallel = light.spread() == Light.Spread.PARALLEL;
        middle = beam.window().bounds().centre();
        startDistance = beam.startDistance();
        object = map.object();
        shape = map.shape();
    }

    /**
     * Aims a ray from a point of the light at a point of the surface. Its measure is the part of light space that the area
     * around that point takes: dA·|cos| across parallel rays, dA·|cos| ÷ r² from a point.
     *
     * @param area the area, in squared scene units, that the ray is to light
     * @return whether the light sends anything there and the surface itself is not in the way
     */
    boolean aim(LightPoint from, Hit at, double area, LightRay ray) {
        double distance = isParallel ? aimParallel(from, at, ray) : aimFromPoint(from, at, ray);
        double cosine =
                Math.abs(ray.directionX * at.normalX + ray.directionY * at.normalY + ray.directionZ * at.normalZ);
        if (!(distance > 0) || !(cosine > 0)) {
            return false;
        }
        light.emit(from, ray.directionX, ray.directionY, ray.directionZ, intensity);
        if (!(intensity.largest() > 0)) {
            return false;
        }
        double section = area * cosine;
        ray.measure = isParallel ? section : section / (distance * distance);
        double error = at.touchingDistance(cosine) + Arithmetic.gamma(64) * distance / Math.max(cosine, FLATTEST);
        ray.aimAt(object, distance, error);
        sight.set(ray.originX, ray.originY, ray.originZ, ray.directionX, ray.directionY, ray.directionZ);
        sight.tMax = distance - error;
        return !shape.occludes(sight);
    }

    /** The brightest colour of what {@link #aim} found the light to send there: W·sr⁻¹, or W·m⁻² across parallel rays. */
    double brightness() {
        return intensity.largest();
    }

    private double aimParallel(LightPoint from, Hit at, LightRay ray) {
        double distance = startDistance
                + (at.x - middle.x()) * from.normalX
                + (at.y - middle.y()) * from.normalY
                + (at.z - middle.z()) * from.normalZ;
        ray.setOrigin(at.x - distance * from.normalX, at.y - distance * from.normalY, at.z - distance * from.normalZ);
        ray.directionX = from.normalX;
        ray.directionY = from.normalY;
        ray.directionZ = from.normalZ;
        return distance;
    }

    private static double aimFromPoint(LightPoint from, Hit at, LightRay ray) {
        double x = at.x - from.x;
        double y = at.y - from.y;
        double z = at.z - from.z;
        ray.setOrigin(from.x, from.y, from.z);
        ray.setDirection(x, y, z);
        return Math.sqrt(x * x + y * y + z * z);
    }
}
