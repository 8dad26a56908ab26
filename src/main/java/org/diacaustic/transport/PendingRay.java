package org.diacaustic.transport;

import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.scene.MediumStack;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.shape.Hit;

/** A ray that is still to be followed, with all that goes along with it. Mutable, and used again and again. */
final class PendingRay {
    /** The fraction of what started that it carries. */
    final Rgb throughput = new Rgb();

    final MediumStack media;

    /** How often the path was mirrored or refracted before. */
    int depth;

    /** The object whose surface it leaves, or none. */
    int object;

    int primitive;

    /** How many surfaces that mean nothing to it lay within the error of its start, one after the other. */
    int passed;

    /** How far before its surface it starts, so that what touches that surface is met. */
    double back;

    /** The length of the path before, in scene units. */
    double pathLength;

    /** Which way the path came; see {@link PathTracer#signature}. */
    long signature;

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

    /** Makes it the first ray of a path. */
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
        pathLength = 0;
        signature = 0;
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
        ray.departureOffset = back;
    }
}
