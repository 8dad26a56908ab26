package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Matrix;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Transform;
import org.diacaustic.math.Vector3;

/**
 * A shape moved, turned, stretched or mirrored. The shape itself is shared: any number of instances cost no more memory
 * than one. The ray is taken to the shape, not the shape to the ray; its direction keeps the length it gets there, so t
 * is the same in both.
 */
public final class Transformed implements Shape {
    private final Shape shape;
    private final Transform transform;
    private final Matrix forward;
    private final Matrix inverse;
    private final Matrix forwardSizes;
    private final Matrix inverseSizes;
    private final double moveX;
    private final double moveY;
    private final double moveZ;
    private final Bounds bounds;

    /** @param transform from the shape's coordinates to the scene's */
    public Transformed(Shape shape, Transform transform) {
        this.shape = shape;
        this.transform = transform;
        this.forward = transform.linear();
        this.inverse = transform.inverseLinear();
        this.forwardSizes = forward.absolute();
        this.inverseSizes = inverse.absolute();
        this.moveX = transform.translation().x();
        this.moveY = transform.translation().y();
        this.moveZ = transform.translation().z();
        this.bounds = bounds(shape.bounds());
    }

    public Shape shape() {
        return shape;
    }

    public Transform transform() {
        return transform;
    }

    @Override
    public Bounds bounds() {
        return bounds;
    }

    private Bounds bounds(Bounds local) {
        if (local.isEmpty() || !local.isFinite()) {
            return local.isEmpty() ? Bounds.EMPTY : Bounds.UNBOUNDED;
        }
        Vector3 middle = local.centre();
        Vector3 half = new Vector3(
                Math.max(local.maxX() - middle.x(), middle.x() - local.minX()),
                Math.max(local.maxY() - middle.y(), middle.y() - local.minY()),
                Math.max(local.maxZ() - middle.z(), middle.z() - local.minZ()));
        Vector3 size = forwardSizes.times(half);
        Vector3 magnitude = forwardSizes.times(new Vector3(
                Math.abs(middle.x()) + half.x(), Math.abs(middle.y()) + half.y(), Math.abs(middle.z()) + half.z()));
        double rounding = Arithmetic.gamma(16);
        return Bounds.around(
                transform.point(middle),
                size.x() + rounding * (magnitude.x() + Math.abs(moveX)),
                size.y() + rounding * (magnitude.y() + Math.abs(moveY)),
                size.z() + rounding * (magnitude.z() + Math.abs(moveZ)));
    }

    @Override
    public boolean intersect(Ray ray) {
        Ray local = toShape(ray);
        boolean found = shape.intersect(local);
        ray.tests += local.tests;
        if (found) {
            ray.hit(local.tMax, local.hitPrimitive);
            ray.hitU = local.hitU;
            ray.hitV = local.hitV;
        }
        return found;
    }

    @Override
    public boolean occludes(Ray ray) {
        Ray local = toShape(ray);
        boolean found = shape.occludes(local);
        ray.tests += local.tests;
        return found;
    }

    private Ray toShape(Ray ray) {
        Ray local = ray.local();
        double x = ray.originX - moveX;
        double y = ray.originY - moveY;
        double z = ray.originZ - moveZ;
        local.set(
                inverse.timesX(x, y, z),
                inverse.timesY(x, y, z),
                inverse.timesZ(x, y, z),
                inverse.timesX(ray.directionX, ray.directionY, ray.directionZ),
                inverse.timesY(ray.directionX, ray.directionY, ray.directionZ),
                inverse.timesZ(ray.directionX, ray.directionY, ray.directionZ));
        local.tMax = ray.tMax;
        local.tests = 0;
        if (ray.leaving != Ray.FREE) {
            local.leaving = ray.leaving;
            local.departureOffset = ray.departureOffset;
            local.departureError = departureError(ray, local);
        }
        return local;
    }

    /** The error of the start in the scene, and of the way from the scene to the shape, in t of the local ray. */
    private double departureError(Ray ray, Ray local) {
        double x = Math.abs(ray.originX) + Math.abs(moveX);
        double y = Math.abs(ray.originY) + Math.abs(moveY);
        double z = Math.abs(ray.originZ) + Math.abs(moveZ);
        double rounding = Arithmetic.gamma(8)
                * Arithmetic.length(
                        inverseSizes.timesX(x, y, z), inverseSizes.timesY(x, y, z), inverseSizes.timesZ(x, y, z));
        double inScene = ray.departureError * Arithmetic.length(ray.directionX, ray.directionY, ray.directionZ);
        return (rounding + inScene * inverse.norm())
                / Arithmetic.length(local.directionX, local.directionY, local.directionZ);
    }

    @Override
    public int piece(Hit hit) {
        return shape.piece(hit);
    }

    @Override
    public void complete(Ray ray, Hit hit) {
        shape.complete(toShape(ray), hit);
        double localError = hit.pointError;
        double x = hit.x;
        double y = hit.y;
        double z = hit.z;
        double sizeX = forwardSizes.timesX(Math.abs(x), Math.abs(y), Math.abs(z)) + Math.abs(moveX);
        double sizeY = forwardSizes.timesY(Math.abs(x), Math.abs(y), Math.abs(z)) + Math.abs(moveY);
        double sizeZ = forwardSizes.timesZ(Math.abs(x), Math.abs(y), Math.abs(z)) + Math.abs(moveZ);
        hit.setPoint(
                forward.timesX(x, y, z) + moveX,
                forward.timesY(x, y, z) + moveY,
                forward.timesZ(x, y, z) + moveZ,
                localError * forward.norm() + Arithmetic.gamma(6) * Arithmetic.length(sizeX, sizeY, sizeZ));
        normalsToScene(hit);
    }

    /** Normals go by the transposed inverse, which keeps them outward even where the transform mirrors. */
    private void normalsToScene(Hit hit) {
        double nx = inverse.transposedTimesX(hit.normalX, hit.normalY, hit.normalZ);
        double ny = inverse.transposedTimesY(hit.normalX, hit.normalY, hit.normalZ);
        double nz = inverse.transposedTimesZ(hit.normalX, hit.normalY, hit.normalZ);
        double sx = inverse.transposedTimesX(hit.shadingX, hit.shadingY, hit.shadingZ);
        double sy = inverse.transposedTimesY(hit.shadingX, hit.shadingY, hit.shadingZ);
        double sz = inverse.transposedTimesZ(hit.shadingX, hit.shadingY, hit.shadingZ);
        double normalLength = Arithmetic.length(nx, ny, nz);
        double shadingLength = Arithmetic.length(sx, sy, sz);
        hit.setNormal(nx / normalLength, ny / normalLength, nz / normalLength);
        hit.shadingX = sx / shadingLength;
        hit.shadingY = sy / shadingLength;
        hit.shadingZ = sz / shadingLength;
    }

    @Override
    public void inverseMap(Hit hit) {
        double x = hit.x;
        double y = hit.y;
        double z = hit.z;
        double nx = hit.normalX;
        double ny = hit.normalY;
        double nz = hit.normalZ;
        double px = x - moveX;
        double py = y - moveY;
        double pz = z - moveZ;
        hit.x = inverse.timesX(px, py, pz);
        hit.y = inverse.timesY(px, py, pz);
        hit.z = inverse.timesZ(px, py, pz);
        normalToShape(hit);
        shape.inverseMap(hit);
        hit.x = x;
        hit.y = y;
        hit.z = z;
        hit.normalX = nx;
        hit.normalY = ny;
        hit.normalZ = nz;
        hit.setTangents(
                forward.timesX(hit.tangentUX, hit.tangentUY, hit.tangentUZ),
                forward.timesY(hit.tangentUX, hit.tangentUY, hit.tangentUZ),
                forward.timesZ(hit.tangentUX, hit.tangentUY, hit.tangentUZ),
                forward.timesX(hit.tangentVX, hit.tangentVY, hit.tangentVZ),
                forward.timesY(hit.tangentVX, hit.tangentVY, hit.tangentVZ),
                forward.timesZ(hit.tangentVX, hit.tangentVY, hit.tangentVZ));
    }

    private void normalToShape(Hit hit) {
        double nx = forward.transposedTimesX(hit.normalX, hit.normalY, hit.normalZ);
        double ny = forward.transposedTimesY(hit.normalX, hit.normalY, hit.normalZ);
        double nz = forward.transposedTimesZ(hit.normalX, hit.normalY, hit.normalZ);
        double length = Arithmetic.length(nx, ny, nz);
        hit.normalX = nx / length;
        hit.normalY = ny / length;
        hit.normalZ = nz / length;
    }

    @Override
    public boolean isClosed() {
        return shape.isClosed();
    }
}
