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

    /** Light that makes more of the pixel is looked at anew for each eye ray, if not all of the pixel sees it. */
    private static final double MUCH = 1.0 / 4;

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

    /** As above for a small square, of the curved object's. */
    private static final double REACH_OF_PART = 1.0 / 8;

    private final Camera camera;
    private final SceneIndex index;
    private final RenderPlan plan;
    private final PathReplay replay;
    private final PixelSquare square;
    private final PixelSquare partSquare;
    private final Footprint footprint = new Footprint();
    private final Footprint otherHalf = new Footprint();
    private final Ray corner = new Ray();
    private final Ray probe = new Ray();
    private final Hit probeHit = new Hit();
    private final SurfacePoint partAt = new SurfacePoint();
    private final Rgb part = new Rgb();
    private long[] trail = new long[16];

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
        this.square = new PixelSquare(camera);
        this.partSquare = new PixelSquare(camera);
    }

    /** The eye ray that is followed now; see {@link Camera#aim}. */
    void startSample(double x, double y, double onLensU, double onLensV) {
        square.startSample(x, y, onLensU, onLensV);
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
        square.takePixel();
        if (depth > 0 && weight < WORTHWHILE) {
            findAbout(ray, pathLength, at);
            return true;
        }
        if (find(depth, signature, at)) {
            return true;
        }
        square.takeAround(PART);
        if (!find(depth, signature, at)) {
            findAbout(ray, pathLength, at);
        }
        return depth > 0 && weight < MUCH;
    }

    private boolean find(int depth, long signature, SurfacePoint at) {
        return depth == 0 ? findDirect(at) : findOverWay(depth, signature, at);
    }

    /** Takes a square as large as if the eye had seen it straight from as far away. */
    private void findAbout(Ray ray, double pathLength, SurfacePoint at) {
        double half = 0.5 * pathLength * square.angle(corner);
        Vector3 direction = new Vector3(ray.directionX, ray.directionY, ray.directionZ);
        Vector3 u = direction.perpendicular();
        Vector3 v = direction.cross(u);
        double cosine = Math.min(-LEAST_COSINE, alongNormal(at, direction.x(), direction.y(), direction.z()));
        isHalved = false;
        for (int i = 0; i < 4; i++) {
            Vector3 off = (i % 2 == 0 ? u : v).times(i < 2 ? half : -half);
            Vector3 onPlane = off.minus(direction.times(alongNormal(at, off.x(), off.y(), off.z()) / cosine));
            square.arrive(i, ray, at.x + onPlane.x(), at.y + onPlane.y(), at.z + onPlane.z());
        }
        isLost = !closeWhole(at);
        if (!isLost) {
            footprint.reach(PART_REACH * square.diagonal());
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
        double reach = reach(index.object(at.object).shape());
        reach = reach < Double.POSITIVE_INFINITY ? REACH_OF_PART * reach : 0;
        int found = 0;
        irradiance.set(0, 0, 0);
        for (int i = 0; i < PARTS * PARTS; i++) {
            partSquare.takePart(square, i, PARTS);
            partSquare.aimAtMiddle(probe);
            if (sees(at.object, at.front) && findOnPlane(partSquare, partAt)) {
                footprint.reach(Math.max(reach, PART_REACH * partSquare.diagonal()));
                if (footprint.close()) {
                    lookup.irradiance(footprint, partAt, part);
                    irradiance.add(part);
                    found++;
                }
            }
        }
        if (found == 0) {
            lookup.irradiance(at, irradiance);
        } else {
            irradiance.scale(1.0 / found);
        }
    }

    /** What the pixel's corners see of the surface itself. */
    private boolean findDirect(SurfacePoint at) {
        if (!findOnPlane(square, at)) {
            return false;
        }
        lookAtSurface(at);
        return isUneven || footprint.close();
    }

    /** What the corners of a square see of the plane in which the surface lies at a point. */
    private boolean findOnPlane(PixelSquare of, SurfacePoint at) {
        for (int i = 0; i < 4; i++) {
            of.aim(i, corner);
            double towards = alongNormal(at, corner.directionX, corner.directionY, corner.directionZ);
            double x = at.x - corner.originX;
            double y = at.y - corner.originY;
            double z = at.z - corner.originZ;
            double t = alongNormal(at, x, y, z) / towards;
            if (!(t > 0 && t < FARTHEST * Arithmetic.length(x, y, z))) {
                return false;
            }
            of.arrive(i, corner, corner.pointX(t), corner.pointY(t), corner.pointZ(t));
        }
        footprint.begin(at);
        of.addCorners(footprint);
        footprint.perspective(corner.originX, corner.originY, corner.originZ, camera.forward(), of.pictureArea());
        return footprint.close();
    }

    private static double alongNormal(SurfacePoint at, double x, double y, double z) {
        return at.normalX * x + at.normalY * y + at.normalZ * z;
    }

    private boolean closeWhole(SurfacePoint at) {
        footprint.begin(at);
        square.addCorners(footprint);
        return footprint.close();
    }

    /** Finds out whether the surface ends within the square, is hidden in part, or curved. */
    private void lookAtSurface(SurfacePoint at) {
        double size = square.diagonal();
        double farthest = 0;
        for (int i = 0; i < 4; i++) {
            square.aim(i, probe);
            if (!sees(at.object, at.front)
                    || alongNormal(at, partAt.normalX, partAt.normalY, partAt.normalZ)
                            <= PhotonFilter.TWO_SIDED_NORMAL.cosine()) {
                isUneven = true;
                return;
            }
            double off = alongNormal(at, partAt.x - at.x, partAt.y - at.y, partAt.z - at.z);
            farthest = Math.max(farthest, Math.abs(off));
        }
        isUneven = farthest > SMOOTH * size;
        if (farthest > FLAT * size) {
            footprint.reach(reach(index.object(at.object).shape()));
        }
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
            square.aim(i, replay.ray());
            if (!replay.follow(plan.mediaAtEye(), trail, depth, signature)) {
                return false;
            }
            Hit place = replay.place();
            farthest = Math.max(farthest, Math.abs(alongNormal(at, place.x - at.x, place.y - at.y, place.z - at.z)));
            square.arrive(i, replay.ray(), place.x, place.y, place.z);
        }
        boolean isFlat = farthest <= FLAT * square.diagonal();
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
        square.addHalf(half, corner);
        half.reach(reach);
        return half.close();
    }
}
