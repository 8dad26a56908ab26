package org.diacaustic.scene;

import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;

/**
 * A pinhole or thin-lens camera. The picture's rows run from the top down; the image plane stands at the focus distance,
 * at right angles to the view, so that everything at that depth is sharp [Thesis 2.2; Cook 1984].
 */
public final class Camera {
    private final Vector3 from;
    private final Vector3 forward;
    private final Vector3 right;
    private final Vector3 up;
    private final int width;
    private final int height;
    private final double halfWidth;
    private final double halfHeight;
    private final double lensRadius;
    private final double focusDistance;

    private Camera(Builder builder, Vector3 forward, Vector3 right) {
        this.from = builder.from;
        this.forward = forward;
        this.right = right;
        this.up = right.cross(forward);
        this.width = builder.width;
        this.height = builder.height;
        this.halfHeight = halfHeight(builder.fieldOfViewDegrees);
        this.halfWidth = halfHeight * width / height;
        this.lensRadius = builder.lensRadius;
        this.focusDistance = Double.isNaN(builder.focusDistance)
                ? builder.to.minus(builder.from).length()
                : builder.focusDistance;
    }

    private Camera(Camera view, int width, int height) {
        this.from = view.from;
        this.forward = view.forward;
        this.right = view.right;
        this.up = view.up;
        this.width = checkedPixels(width, width, height);
        this.height = checkedPixels(height, width, height);
        this.halfHeight = view.halfHeight;
        this.halfWidth = halfHeight * width / height;
        this.lensRadius = view.lensRadius;
        this.focusDistance = view.focusDistance;
    }

    /** The tangent of half the angle; of a wide one, whose difference from 180° has all its digits, by its complement. */
    private static double halfHeight(double degrees) {
        return degrees <= 90
                ? StrictMath.tan(StrictMath.toRadians(degrees) / 2)
                : 1 / StrictMath.tan(StrictMath.toRadians(180 - degrees) / 2);
    }

    private static int checkedPixels(int side, int across, int down) {
        if (side < 1) {
            throw new IllegalArgumentException(
                    "a picture needs at least 1 x 1 pixels, but has " + across + " x " + down);
        }
        return side;
    }

    public static Builder builder() {
        return new Builder();
    }

    public Vector3 from() {
        return from;
    }

    public int width() {
        return width;
    }

    public int height() {
        return height;
    }

    /** The direction of the view, of length 1. */
    public Vector3 forward() {
        return forward;
    }

    /** The area of a pixel on a plane across the view at a distance of 1. */
    public double pixelArea() {
        return 4 * halfWidth * halfHeight / ((double) width * height);
    }

    /** In scene units; 0 for a pinhole. */
    public double lensRadius() {
        return lensRadius;
    }

    /**
     * The same view at another size in pixels; the vertical field of view stays.
     *
     * @throws IllegalArgumentException if a side is smaller than 1
     */
    public Camera withSize(int newWidth, int newHeight) {
        return new Camera(this, newWidth, newHeight);
    }

    /**
     * Sets the ray through a point of the picture.
     *
     * @param x from 0 at the left edge to {@link #width()} at the right
     * @param y from 0 at the top edge to {@link #height()} at the bottom
     * @param lensU first coordinate on the lens, uniform in 0..1; not used by a pinhole
     * @param lensV second coordinate
     */
    public void aim(double x, double y, double lensU, double lensV, Ray ray) {
        double a = halfWidth * (2 * x / width - 1);
        double b = halfHeight * (1 - 2 * y / height);
        double dx = forward.x() + a * right.x() + b * up.x();
        double dy = forward.y() + a * right.y() + b * up.y();
        double dz = forward.z() + a * right.z() + b * up.z();
        double ox = from.x();
        double oy = from.y();
        double oz = from.z();
        if (lensRadius > 0) {
            double distance = lensRadius * Math.sqrt(lensU);
            double angle = 2 * Math.PI * lensV;
            double s = distance * StrictMath.cos(angle);
            double t = distance * StrictMath.sin(angle);
            double sx = s * right.x() + t * up.x();
            double sy = s * right.y() + t * up.y();
            double sz = s * right.z() + t * up.z();
            // From the point on the lens to the point of the focal plane that the pinhole ray meets.
            dx -= sx / focusDistance;
            dy -= sy / focusDistance;
            dz -= sz / focusDistance;
            ox += sx;
            oy += sy;
            oz += sz;
        }
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        ray.set(ox, oy, oz, dx / length, dy / length, dz / length);
    }

    /** Collects the parts of a camera: looks from the origin along −z, 40° high, 200×200, if nothing else is said. */
    public static final class Builder {
        private Vector3 from = Vector3.ZERO;
        private Vector3 to = new Vector3(0, 0, -1);
        private Vector3 up = Vector3.UNIT_Y;
        private double fieldOfViewDegrees = 40;
        private int width = 200;
        private int height = 200;
        private double lensRadius;
        private double focusDistance = Double.NaN;

        private Builder() {}

        public Builder from(Vector3 point) {
            from = point;
            return this;
        }

        public Builder to(Vector3 point) {
            to = point;
            return this;
        }

        public Builder up(Vector3 direction) {
            up = direction;
            return this;
        }

        /** @param degrees of the whole vertical angle of view, between 0 and 180 */
        public Builder fieldOfView(double degrees) {
            if (!(degrees > 0 && degrees < 180)) {
                throw new IllegalArgumentException(
                        "a field of view must be between 0 and 180 degrees, but is " + degrees);
            }
            fieldOfViewDegrees = degrees;
            return this;
        }

        /** In pixels. */
        public Builder size(int pixelsAcross, int pixelsDown) {
            width = checkedPixels(pixelsAcross, pixelsAcross, pixelsDown);
            height = checkedPixels(pixelsDown, pixelsAcross, pixelsDown);
            return this;
        }

        /**
         * @param lens radius of the aperture, in scene units; 0 for a pinhole
         * @param focus depth of what is sharp, measured along the axis; positive, infinite for what is endlessly far away
         */
        public Builder lens(double lens, double focus) {
            if (!(lens >= 0 && lens < Double.POSITIVE_INFINITY && focus > 0)) {
                throw new IllegalArgumentException("a lens needs a radius of at least 0 and a positive focus distance,"
                        + " but has " + lens + " and " + focus);
            }
            lensRadius = lens;
            focusDistance = focus;
            return this;
        }

        /** @throws IllegalArgumentException if from and to coincide, or up runs along the view */
        public Camera build() {
            Vector3 view = to.minus(from);
            if (!from.isFinite() || !view.isFinite() || !(view.length() > 0)) {
                throw new IllegalArgumentException(
                        "a camera's 'from' " + from + " and 'to' " + to + " must be two different finite points");
            }
            Vector3 forward = view.normalized();
            if (!up.isFinite() || !(up.length() > 0)) {
                throw new IllegalArgumentException("a camera's 'up' must be a direction, but is " + up);
            }
            Vector3 right = forward.cross(up.normalized());
            if (!(right.length() > 1e-9)) {
                throw new IllegalArgumentException(
                        "a camera's 'up' " + up + " must not run along the view from " + from + " to " + to);
            }
            return new Camera(this, forward, right.normalized());
        }
    }
}
