package org.diacaustic.trial;

import org.diacaustic.material.TransportMode;
import org.diacaustic.math.CompensatedSum;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MediumLocator;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.Settings;
import org.diacaustic.transport.PathRules;
import org.diacaustic.transport.PathTracer;

/**
 * Follows single light rays by the walk that both passes of a render share, and keeps what they meet. Of a ray that splits, the
 * last leg is that of the branch that came to its end last.
 */
final class RayWalk extends PathTracer {
    private final SceneIndex index;
    private final StopSignal never = new StopSignal();
    private CompensatedSum visited = new CompensatedSum();
    private CompensatedSum kept = new CompensatedSum();
    private CompensatedSum escaped = new CompensatedSum();
    private CompensatedSum cut = new CompensatedSum();
    private long visits;
    private long totalReflections;
    private double widestCosine;
    private double arriving;
    private int deepest;
    private Vector3 origin;
    private Vector3 direction;
    private boolean isSpoiled;

    private RayWalk(SceneIndex index, PathRules rules) {
        super(index, rules);
        this.index = index;
    }

    /** Walks by the forward settings, which say how often light is mirrored or refracted; none is too weak. */
    static RayWalk in(Scene scene, Settings settings) {
        ForwardSettings forward = settings.forward();
        return new RayWalk(
                SceneIndex.of(scene.objects(), settings.usesListOrder()),
                new PathRules(
                        settings.scatterRules(),
                        TransportMode.FLUX,
                        forward.maxDepth(),
                        0,
                        forward.followsReflections(),
                        settings.usesListOrder()));
    }

    /** Follows a ray, and forgets the one before. */
    RayWalk follow(Vector3 from, Vector3 towards) {
        visited = new CompensatedSum();
        kept = new CompensatedSum();
        escaped = new CompensatedSum();
        cut = new CompensatedSum();
        visits = 0;
        totalReflections = 0;
        widestCosine = 0;
        arriving = 0;
        deepest = -1;
        isSpoiled = false;
        ray.set(from, towards.normalized());
        followAll(MediumLocator.locate(index, from), never);
        return this;
    }

    @Override
    protected boolean arrive(int object, int side) {
        visits++;
        visited.add(throughput.green);
        if (depth > deepest) {
            deepest = depth;
            arriving = throughput.green;
        }
        double cosine =
                Math.abs(ray.directionX * hit.normalX + ray.directionY * hit.normalY + ray.directionZ * hit.normalZ);
        widestCosine = Math.max(widestCosine, cosine);
        totalReflections += scattering.totalInternalReflection ? 1 : 0;
        if (index.isOpaque(object)) {
            kept.add(throughput.green * (1 - scattering.reflectance.green));
        }
        keepLeg();
        return true;
    }

    @Override
    protected void end() {
        escaped.add(throughput.green);
        keepLeg();
    }

    private void keepLeg() {
        origin = new Vector3(ray.originX, ray.originY, ray.originZ);
        direction = new Vector3(ray.directionX, ray.directionY, ray.directionZ);
    }

    @Override
    protected void cut(Rgb fraction) {
        cut.add(fraction.green);
    }

    @Override
    protected void spoiled() {
        isSpoiled = true;
    }

    /** How often a surface was met. */
    long visits() {
        return visits;
    }

    /** What was carried there each time, summed. */
    double visited() {
        return visited.value();
    }

    /** Kept by opaque surfaces. */
    double kept() {
        return kept.value();
    }

    double escaped() {
        return escaped.value();
    }

    /** Not followed any more, for it was mirrored or refracted too often, or such light is not to be followed. */
    double cut() {
        return cut.value();
    }

    /** How often light was mirrored wholly where it could have gone on. */
    long totalReflections() {
        return totalReflections;
    }

    /** How often the path was turned that was turned most; −1 if it met nothing. */
    int deepest() {
        return deepest;
    }

    /** What arrived after the most turns. */
    double arriving() {
        return arriving;
    }

    /** The smallest angle of incidence, in degrees. */
    double smallestIncidence() {
        return StrictMath.toDegrees(StrictMath.acos(Math.min(1, widestCosine)));
    }

    boolean isSpoiled() {
        return isSpoiled;
    }

    /** Where the last leg began. */
    Vector3 origin() {
        return origin;
    }

    Vector3 direction() {
        return direction;
    }

    /** The x at which the line of the last leg comes to a height. */
    double landing(double height) {
        return origin.x() + direction.x() / direction.y() * (height - origin.y());
    }

    /** The height at which the line of the last leg comes to x = 0. */
    double crossing() {
        return origin.y() - origin.x() * (direction.y() / direction.x());
    }
}
