package org.diacaustic.render;

import java.util.Arrays;
import org.diacaustic.map.Footprint;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.map.PhotonFilter;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Shape;
import org.diacaustic.transport.PathReplay;

/**
 * Finds what of a surface is seen through a pixel, straight or over mirrors and through glass: the rays of the pixel's corners
 * go the way of the ray within. Where they do not all come the same way, a smaller square around the ray is taken; and
 * where those do not either, or it matters little, one about as large as is seen straight from so far away. Owned by one
 * task.
 */
final class PixelFootprint {
    /** The side of the smaller square. */
    private static final double PART = 0.25;

    /** Light that makes less of the pixel is not worth rays of its own, nor is its error. */
    static final double WORTHWHILE = 1.0 / 16;

    /** The cosine below which a square seen at a flat angle grows no longer. */
    private static final double LEAST_COSINE = 1.0 / 16;

    /** A corner may be so many times farther away than the point within, before the square is too large. */
    private static final double FARTHEST = 4;

    /** What lies off the plane by less than this part of the footprint is flat. */
    private static final double FLAT = 0x1p-20;

    /** And by less than this, is one surface. */
    private static final double SMOOTH = 0x1p-3;

    /** The part of a curved object's size within which light on it belongs to what is seen. */
    private static final double REACH = 1.0 / 64;

    /** Small squares along the side of one that sees a surface end, or bend much, or hidden in part. */
    private static final int PARTS = 4;

    /** How far before and behind a small square light belongs to it, in sizes of what it sees. */
    private static final double PART_REACH = 2;

    private final Camera camera;
    private final SceneIndex index;
    private final RenderPlan plan;
    private final PathReplay replay;
    private final Footprint footprint = new Footprint();
    private final Footprint otherHalf = new Footprint();
    private final Ray corner = new Ray();
    private final Ray probe = new Ray();
    private final Hit probeHit = new Hit();
    private final double[] points = new double[12];
    private final double[] directions = new double[12];
    private final SurfacePoint partAt = new SurfacePoint();
    private final Rgb part = new Rgb();
    private long[] trail = new long[16];
    private double left;
    private double top;
    private double side;
    private double sampleX;
    private double sampleY;
    private double lensU;
    private double lensV;

    /** Whether the footprint consists of two triangles. */
    private boolean isHalved;

    /** Whether there is none, and a point has to do. */
    private boolean isLost;

    /** Whether small squares must be looked at one by one. */
    private boolean isUneven;

    PixelFootprint(RenderPlan plan) {
        this.plan = plan;
        this.camera = plan.scene().camera();
        this.index = plan.index();
        this.replay = new PathReplay(index, plan.eyeRules(0));
    }

    /** The eye ray that is followed now; see {@link Camera#aim}. */
    void startSample(double x, double y, double onLensU, double onLensV) {
        sampleX = x;
        sampleY = y;
        lensU = onLensU;
        lensV = onLensV;
    }

    /** Notes the way of the eye ray: at this depth it had this signature. */
    void pass(int depth, long signature) {
        if (depth >= trail.length) {
            trail = Arrays.copyOf(trail, 2 * depth);
        }
        trail[depth] = signature;
    }

    long tests() {
        return replay.testCount() + probe.tests;
    }

    /**
     * Finds the footprint of the pixel, or of a part of it, where the eye ray has arrived.
     *
     * @param signature of the eye's path with its end
     * @param pathLength how long the eye's path is, in scene units
     * @param weight the part of the pixel's light that may come from here
     * @return whether it will do for the whole pixel
     */
    boolean find(int depth, long signature, Ray ray, double pathLength, double weight, SurfacePoint at) {
        isHalved = false;
        isUneven = false;
        isLost = false;
        left = Math.floor(sampleX);
        top = Math.floor(sampleY);
        side = 1;
        if (depth > 0 && weight < WORTHWHILE) {
            findAbout(ray, pathLength, at);
            return true;
        }
        if (depth == 0 ? findDirect(at) : findOverWay(depth, signature, at)) {
            return true;
        }
        side = PART;
        left = sampleX - side / 2;
        top = sampleY - side / 2;
        if (!(depth == 0 ? findDirect(at) : findOverWay(depth, signature, at))) {
            findAbout(ray, pathLength, at);
        }
        return false;
    }

    /** Takes a square as large as if the eye had seen it straight from as far away. */
    private void findAbout(Ray ray, double pathLength, SurfacePoint at) {
        camera.aim(left, top, lensU, lensV, corner);
        double x = corner.directionX;
        double y = corner.directionY;
        double z = corner.directionZ;
        camera.aim(left + side, top + side, lensU, lensV, corner);
        double angle = Arithmetic.length(corner.directionX - x, corner.directionY - y, corner.directionZ - z);
        double half = 0.5 * pathLength * angle;
        Vector3 direction = new Vector3(ray.directionX, ray.directionY, ray.directionZ);
        Vector3 u = direction.perpendicular();
        Vector3 v = direction.cross(u);
        double cosine = Math.min(-LEAST_COSINE, alongNormal(at, direction.x(), direction.y(), direction.z()));
        isHalved = false;
        isUneven = false;
        for (int i = 0; i < 4; i++) {
            Vector3 off = (i % 2 == 0 ? u : v).times(i < 2 ? half : -half);
            Vector3 onPlane = off.minus(direction.times(alongNormal(at, off.x(), off.y(), off.z()) / cosine));
            setCorner(i, ray, at.x + onPlane.x(), at.y + onPlane.y(), at.z + onPlane.z());
        }
        isLost = !closeWhole(at);
        if (!isLost) {
            footprint.reach(PART_REACH * diagonal());
            isLost = !footprint.close();
        }
    }

    /** Sets the mean irradiance in the footprint that was found. */
    void ask(IlluminationMap.Lookup lookup, SurfacePoint at, Rgb irradiance) {
        if (isLost) {
            lookup.irradiance(at, irradiance);
            return;
        }
        if (isUneven) {
            askParts(lookup, at, irradiance);
            return;
        }
        lookup.irradiance(footprint, at, irradiance);
        if (isHalved) {
            lookup.irradiance(otherHalf, at, part);
            double area = footprint.area() + otherHalf.area();
            irradiance.scale(footprint.area() / area);
            part.scale(otherHalf.area() / area);
            irradiance.add(part);
        }
    }

    /** The mean over small squares of the pixel, each of which sees a surface of its own of the same object. */
    private void askParts(IlluminationMap.Lookup lookup, SurfacePoint at, Rgb irradiance) {
        double size = side;
        double x = left;
        double y = top;
        side /= PARTS;
        int found = 0;
        irradiance.set(0, 0, 0);
        for (int i = 0; i < PARTS * PARTS; i++) {
            left = x + i % PARTS * side;
            top = y + i / PARTS * side;
            camera.aim(left + 0.5 * side, top + 0.5 * side, lensU, lensV, probe);
            if (sees(at.object, at.front) && findOnPlane(partAt)) {
                footprint.reach(PART_REACH * diagonal());
                if (footprint.close()) {
                    lookup.irradiance(footprint, partAt, part);
                    irradiance.add(part);
                    found++;
                }
            }
        }
        side = size;
        left = x;
        top = y;
        if (found == 0) {
            lookup.irradiance(at, irradiance);
        } else {
            irradiance.scale(1.0 / found);
        }
    }

    private void aim(int corner, Ray ray) {
        double x = left + (corner == 1 || corner == 2 ? side : 0);
        double y = top + (corner >= 2 ? side : 0);
        camera.aim(x, y, lensU, lensV, ray);
    }

    /** What the pixel's corners see of the surface itself. */
    private boolean findDirect(SurfacePoint at) {
        if (!findOnPlane(at)) {
            return false;
        }
        lookAtShape(at, index.object(at.object).shape());
        return isUneven || footprint.close();
    }

    /** What the corners see of the plane in which the surface lies at a point. */
    private boolean findOnPlane(SurfacePoint at) {
        for (int i = 0; i < 4; i++) {
            aim(i, corner);
            double towards = alongNormal(at, corner.directionX, corner.directionY, corner.directionZ);
            double x = at.x - corner.originX;
            double y = at.y - corner.originY;
            double z = at.z - corner.originZ;
            double t = alongNormal(at, x, y, z) / towards;
            if (!(t > 0 && t < FARTHEST * Arithmetic.length(x, y, z))) {
                return false;
            }
            setCorner(i, corner, corner.pointX(t), corner.pointY(t), corner.pointZ(t));
        }
        footprint.begin(at);
        addCorners(footprint);
        footprint.perspective(
                corner.originX, corner.originY, corner.originZ, camera.forward(), side * side * camera.pixelArea());
        return footprint.close();
    }

    private static double alongNormal(SurfacePoint at, double x, double y, double z) {
        return at.normalX * x + at.normalY * y + at.normalZ * z;
    }

    private void setCorner(int i, Ray ray, double x, double y, double z) {
        points[3 * i] = x;
        points[3 * i + 1] = y;
        points[3 * i + 2] = z;
        directions[3 * i] = ray.directionX;
        directions[3 * i + 1] = ray.directionY;
        directions[3 * i + 2] = ray.directionZ;
    }

    private boolean closeWhole(SurfacePoint at) {
        footprint.begin(at);
        addCorners(footprint);
        return footprint.close();
    }

    private void addCorners(Footprint to) {
        for (int i = 0; i < 4; i++) {
            addCorner(to, i);
        }
    }

    private void addCorner(Footprint to, int i) {
        to.addCorner(
                points[3 * i],
                points[3 * i + 1],
                points[3 * i + 2],
                directions[3 * i],
                directions[3 * i + 1],
                directions[3 * i + 2]);
    }

    /** Finds out whether the surface ends within the square, is hidden in part, or curved. */
    private void lookAtShape(SurfacePoint at, Shape shape) {
        double size = diagonal();
        double farthest = 0;
        for (int i = 0; i < 4; i++) {
            aim(i, probe);
            if (!sees(at.object, at.front)) {
                isUneven = true;
                return;
            }
            double cosine = at.normalX * partAt.normalX + at.normalY * partAt.normalY + at.normalZ * partAt.normalZ;
            double off = Math.abs(alongNormal(at, partAt.x - at.x, partAt.y - at.y, partAt.z - at.z));
            farthest = cosine > PhotonFilter.TWO_SIDED_NORMAL.cosine()
                    ? Math.max(farthest, off)
                    : Double.POSITIVE_INFINITY;
        }
        if (farthest > SMOOTH * size) {
            isUneven = true;
        } else if (farthest > FLAT * size) {
            footprint.reach(reach(shape));
        }
    }

    private double diagonal() {
        return Math.max(distance(0, 2), distance(1, 3));
    }

    private double distance(int i, int j) {
        return Arithmetic.length(
                points[3 * i] - points[3 * j],
                points[3 * i + 1] - points[3 * j + 1],
                points[3 * i + 2] - points[3 * j + 2]);
    }

    /** Whether the probe sees the object's side before all others, and where. */
    private boolean sees(int object, boolean front) {
        if (index.nearest(probe, SceneIndex.NONE, 0) != object) {
            return false;
        }
        Shape shape = index.object(object).shape();
        probeHit.take(probe);
        shape.complete(probe, probeHit);
        double cosine = probe.directionX * probeHit.normalX
                + probe.directionY * probeHit.normalY
                + probe.directionZ * probeHit.normalZ;
        double sign = cosine < 0 ? 1 : -1;
        partAt.x = probeHit.x;
        partAt.y = probeHit.y;
        partAt.z = probeHit.z;
        partAt.normalX = sign * probeHit.normalX;
        partAt.normalY = sign * probeHit.normalY;
        partAt.normalZ = sign * probeHit.normalZ;
        partAt.object = object;
        partAt.front = front;
        return cosine < 0 == front;
    }

    private static double reach(Shape shape) {
        return shape.bounds().isFinite() ? REACH * 2 * shape.bounds().radius() : Double.POSITIVE_INFINITY;
    }

    /** What the pixel's corners see over the same mirrors and through the same glass. */
    private boolean findOverWay(int depth, long signature, SurfacePoint at) {
        double farthest = 0;
        for (int i = 0; i < 4; i++) {
            aim(i, replay.ray());
            if (!replay.follow(plan.mediaAtEye(), trail, depth, signature)) {
                return false;
            }
            Hit place = replay.place();
            farthest = Math.max(farthest, Math.abs(alongNormal(at, place.x - at.x, place.y - at.y, place.z - at.z)));
            setCorner(i, replay.ray(), place.x, place.y, place.z);
        }
        boolean isFlat = farthest <= FLAT * diagonal();
        double reach = isFlat ? 0 : reach(index.object(at.object).shape());
        if (closeWhole(at)) {
            footprint.reach(reach);
            return footprint.close();
        }
        // Seen through glass a square may be folded: then it is two triangles.
        isHalved = true;
        return closeHalf(footprint, at, 1, reach) && closeHalf(otherHalf, at, 3, reach);
    }

    private boolean closeHalf(Footprint half, SurfacePoint at, int corner, double reach) {
        half.begin(at);
        addCorner(half, 0);
        addCorner(half, corner);
        addCorner(half, 2);
        half.reach(reach);
        return half.close();
    }
}
