package org.diacaustic.render;

import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.scene.MediumStack;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.shape.Hit;

/** A ray that is still to be followed, with all that goes along with it. Mutable, and used again and again. */
final class PendingRay {
    /** The fraction of the radiance it finds that reaches the eye. */
    final Rgb throughput = new Rgb();

    final MediumStack media;

    /** How often light on this way was mirrored or refracted between here and the eye. */
    int depth;

    /** The object whose surface it leaves, or none. */
    int object;

    int primitive;

    /** How many surfaces that mean nothing to it lay within the error of its start, one after the other. */
    int passed;

    /** How far before its surface it starts, so that what touches that surface is met. */
    double back;

    private double originX;
    private double originY;
    private double originZ;
    private double directionX;
    private double directionY;
    private double directionZ;
    private double departureError;

    PendingRay(SceneIndex scene) {
        media = new MediumStack(scene);
    }

    /** Makes it the ray from the eye. */
    void start(Ray ray) {
        originX = ray.originX;
        originY = ray.originY;
        originZ = ray.originZ;
        directionX = ray.directionX;
        directionY = ray.directionY;
        directionZ = ray.directionZ;
        departureError = 0;
        back = 0;
        passed = 0;
        depth = 0;
        object = SceneIndex.NONE;
        primitive = 0;
    }

    /** Makes it a ray that leaves a hit in a direction, starting {@code before} it. */
    void leave(Hit hit, int hitObject, double dx, double dy, double dz, double before) {
        originX = hit.x - before * dx;
        originY = hit.y - before * dy;
        originZ = hit.z - before * dz;
        directionX = dx;
        directionY = dy;
        directionZ = dz;
        departureError = hit.pointError + before;
        back = before;
        object = hitObject;
        primitive = hit.primitive;
        passed = 0;
    }

    /** Keeps at least this error of the start, and counts one more surface passed. */
    void pass(double errorSoFar, int passedSoFar) {
        departureError = Math.max(departureError, errorSoFar);
        passed = passedSoFar + 1;
    }

    /** Sets the ray to be traced. */
    void copyTo(Ray ray) {
        ray.set(originX, originY, originZ, directionX, directionY, directionZ);
        ray.departureError = departureError;
    }
}
