package org.diacaustic.preprocess;

import java.util.Arrays;
import org.diacaustic.light.LightPoint;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Rgb;
import org.diacaustic.parallel.StopSignal;

/**
 * Follows light rays along one way that is known by its signature, and no other branch. The first ray of a way is followed with
 * all branches, to learn what signatures it has on the way; further rays of the same one are not. Owned by one task.
 */
final class WayTracer extends LightPathTracer {
    /** A way is not looked for among branches that carry a smaller fraction of their ray's flux. */
    private static final double LEAST_THROUGHPUT = 0x1p-16;

    private final double least;
    private final Rgb flux = new Rgb();

    /** Of the way that is known: its signature with its end, and for each depth the one on the way. */
    private long knownEnd;

    private long[] way = new long[16];
    private int depthAtEnd;
    private boolean isKnown;

    private long end;
    private SurfacePoint place;
    private Rgb power;
    private boolean hasLanded;

    WayTracer(ForwardPlan plan) {
        super(plan.index(), plan.rules(), new StopSignal());
        least = plan.rouletteThroughput() > 0 ? LEAST_THROUGHPUT : 0;
    }

    /**
     * Follows a ray from a point of the beam's light.
     *
     * @param signature of the way with its end
     * @param at set to where it lands
     * @param landing set to the power that lands for a unit of light space, of the whole light
     * @return whether it came that way
     */
    boolean follow(Beam from, LightPoint point, LightRay primary, long signature, SurfacePoint at, Rgb landing) {
        end = signature;
        place = at;
        power = landing;
        isKnown &= signature == knownEnd;
        hasLanded = false;
        from.light().emit(point, primary.directionX, primary.directionY, primary.directionZ, flux);
        if (!flux.isBlack()) {
            follow(from, primary);
        }
        return hasLanded;
    }

    @Override
    protected void meets() {
        if (!isKnown && !hasLanded) {
            if (depth >= way.length) {
                way = Arrays.copyOf(way, 2 * depth);
            }
            way[depth] = signature;
        }
    }

    @Override
    protected void lands(int object, int side) {
        if (hasLanded || signatureAt(object, side) != end) {
            return;
        }
        hasLanded = true;
        isKnown = true;
        knownEnd = end;
        depthAtEnd = depth;
        place.x = hit.x;
        place.y = hit.y;
        place.z = hit.z;
        place.normalX = side * hit.normalX;
        place.normalY = side * hit.normalY;
        place.normalZ = side * hit.normalZ;
        place.object = object;
        place.front = side > 0;
        power.set(flux).multiply(throughput).scale(beam().light().depositFactor(pathLength));
    }

    /** All branches until the way is known; then only those on it. */
    @Override
    protected boolean survives(long path, Rgb fraction, double largest) {
        if (hasLanded) {
            return false;
        }
        return isKnown ? depth < depthAtEnd && path == way[depth + 1] : largest >= least;
    }

    @Override
    protected boolean enters(int object) {
        return true;
    }

    @Override
    protected void starts(Rgb lost) {}

    @Override
    protected void staysDirect() {}

    @Override
    protected void keepsRest() {}

    @Override
    protected void escapes() {}

    @Override
    protected void cut(Rgb fraction) {}

    @Override
    protected void spoiled() {}
}
