package org.diacaustic.transport;

import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.scene.MediumStack;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.shape.Hit;

/** Follows a ray along the way that another has come, and no other branch. Owned by one task, used for many rays. */
public final class PathReplay extends PathTracer {
    private static final StopSignal NEVER = new StopSignal();

    private final Hit place = new Hit();
    private long[] trail = new long[0];
    private long signatureAtEnd;
    private int depthAtEnd;
    private boolean arrived;

    public PathReplay(SceneIndex scene, PathRules rules) {
        super(scene, rules);
    }

    /** The ray to aim before {@link #follow}; then the last part of its way. */
    public Ray ray() {
        return ray;
    }

    /** Where it arrived. */
    public Hit place() {
        return place;
    }

    /**
     * Follows the ray.
     *
     * @param way for each depth, the signature of the path to follow
     * @param depth how often that was mirrored or refracted in all
     * @param signature of that path with its end
     * @return whether the ray came the same way to the same side of the same object
     */
    public boolean follow(MediumStack mediaAtStart, long[] way, int depth, long signature) {
        trail = way;
        depthAtEnd = depth;
        signatureAtEnd = signature;
        arrived = false;
        followAll(mediaAtStart, NEVER);
        return arrived;
    }

    @Override
    protected boolean arrive(int object, int side) {
        if (depth < depthAtEnd) {
            return true;
        }
        arrived = signatureAt(object, side) == signatureAtEnd;
        if (arrived) {
            place.copyPlace(hit);
        }
        return false;
    }

    @Override
    protected boolean survives(long path, Rgb fraction, double largest) {
        return path == trail[depth + 1];
    }

    @Override
    protected void end() {}

    @Override
    protected void cut(Rgb fraction) {}

    @Override
    protected void spoiled() {}

    /** The number of tests so far. */
    public long testCount() {
        return tests();
    }
}
