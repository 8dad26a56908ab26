package org.diacaustic.study;

import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;

/**
 * Where in the picture a pinhole camera sees a point: the inverse of {@link Camera#aim}, found from rays that it aims.
 * Immutable.
 */
final class PinholeView {
    private final Camera camera;
    private final Vector3 from;
    private final Vector3 forward;
    /** From the eye to the top left corner of the picture, one unit along {@link #forward} away. */
    private final Vector3 corner;

    private final Vector3 across;
    private final Vector3 down;

    /** @throws IllegalArgumentException if the camera has a lens, through which a point is seen in many pixels */
    PinholeView(Camera camera) {
        if (camera.lensRadius() > 0) {
            throw new IllegalArgumentException(
                    "light is traced to the pixels of a pinhole camera only, but this one has a" + " lens-radius of "
                            + camera.lensRadius());
        }
        this.camera = camera;
        this.from = camera.from();
        this.forward = direction(0.5 * camera.width(), 0.5 * camera.height());
        this.corner = onPlane(0, 0);
        this.across = onPlane(camera.width(), 0).minus(corner).times(1.0 / camera.width());
        this.down = onPlane(0, camera.height()).minus(corner).times(1.0 / camera.height());
    }

    private Vector3 direction(double x, double y) {
        Ray ray = new Ray();
        camera.aim(x, y, 0, 0, ray);
        return new Vector3(ray.directionX, ray.directionY, ray.directionZ);
    }

    private Vector3 onPlane(double x, double y) {
        Vector3 direction = direction(x, y);
        return direction.times(1 / direction.dot(forward));
    }

    /**
     * Aims the ray at a point, and finds the pixel there.
     *
     * @param ray its {@code tMax} is set free
     * @return the number of the pixel, row by row from the top left, or −1 if the point is not in the picture
     */
    int aim(double x, double y, double z, Ray ray) {
        double column = Math.floor(column(x, y, z));
        double row = Math.floor(row(x, y, z));
        if (!(column >= 0 && column < camera.width() && row >= 0 && row < camera.height())) {
            return -1;
        }
        double dx = x - from.x();
        double dy = y - from.y();
        double dz = z - from.z();
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        ray.set(from.x(), from.y(), from.z(), dx / length, dy / length, dz / length);
        return (int) row * camera.width() + (int) column;
    }

    /** Where a point is seen, in pixels from the left; not a number if it is not before the eye. */
    double column(double x, double y, double z) {
        return seen(x, y, z, across);
    }

    /** The same from the top. */
    double row(double x, double y, double z) {
        return seen(x, y, z, down);
    }

    private double seen(double x, double y, double z, Vector3 step) {
        double dx = x - from.x();
        double dy = y - from.y();
        double dz = z - from.z();
        double depth = dx * forward.x() + dy * forward.y() + dz * forward.z();
        return depth > 0
                ? along(dx / depth - corner.x(), dy / depth - corner.y(), dz / depth - corner.z(), step)
                : Double.NaN;
    }

    private static double along(double x, double y, double z, Vector3 step) {
        return (x * step.x() + y * step.y() + z * step.z()) / step.dot(step);
    }

    /** How many pixels a steradian about the ray is worth. */
    double pixelsPerSteradian(Ray ray) {
        double cosine = ray.directionX * forward.x() + ray.directionY * forward.y() + ray.directionZ * forward.z();
        return 1 / (cosine * cosine * cosine * across.length() * down.length());
    }
}
