package org.diacaustic.shape;

import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;

/** A sphere met by b² − 4ac and a smallest distance, as one writes it first; all but the test is {@link Sphere}'s. */
public final class TextbookSphere implements Shape {
    private static final double SMALLEST = 1e-6;

    private final Sphere sphere;
    private final double x;
    private final double y;
    private final double z;
    private final double radiusSquared;

    public TextbookSphere(Sphere sphere) {
        this.sphere = sphere;
        x = sphere.centre().x();
        y = sphere.centre().y();
        z = sphere.centre().z();
        radiusSquared = sphere.radius() * sphere.radius();
    }

    @Override
    public boolean intersect(Ray ray) {
        ray.tests++;
        double fx = ray.originX - x;
        double fy = ray.originY - y;
        double fz = ray.originZ - z;
        double dx = ray.directionX;
        double dy = ray.directionY;
        double dz = ray.directionZ;
        double a = dx * dx + dy * dy + dz * dz;
        double b = 2 * (fx * dx + fy * dy + fz * dz);
        double c = fx * fx + fy * fy + fz * fz - radiusSquared;
        double discriminant = b * b - 4 * a * c;
        if (discriminant < 0) {
            return false;
        }
        double root = Math.sqrt(discriminant);
        double t = (-b - root) / (2 * a);
        if (t < SMALLEST) {
            t = (-b + root) / (2 * a);
        }
        if (t < SMALLEST || t >= ray.tMax) {
            return false;
        }
        ray.hit(t, 0);
        return true;
    }

    @Override
    public Bounds bounds() {
        return sphere.bounds();
    }

    @Override
    public void complete(Ray ray, Hit hit) {
        sphere.complete(ray, hit);
    }

    @Override
    public void inverseMap(Hit hit) {
        sphere.inverseMap(hit);
    }

    @Override
    public boolean isClosed() {
        return true;
    }
}
