package org.diacaustic.preprocess;

import org.diacaustic.light.Light;
import org.diacaustic.light.LightPoint;
import org.diacaustic.map.InitialHits;
import org.diacaustic.map.PhotonSlice;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.SampleStream;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.transport.PathTracer;

/**
 * Follows light rays from a light, over what mirrors and refracts them, and stores a photon at every diffuse surface that
 * they reach then. What they light before that is direct light, which is not its business [Thesis 4.1].
 */
final class LightTracer extends PathTracer {
    private final ForwardPlan plan;
    private final StopSignal stop;
    /** Null unless areas of refracting objects let only some rays through. */
    private final InitialHits initialHits;

    private final SampleStream roulette = new SampleStream();
    private final Ray upstream = new Ray();
    private final SurfacePoint at = new SurfacePoint();
    private final Rgb flux = new Rgb();
    private final Rgb part = new Rgb();
    private PhotonSlice photons;
    private EnergyLedger ledger;
    private ForwardCounters counters;
    private Beam beam;
    private LightRay primary;
    private boolean isStoring;
    private int stored;

    /** The first object whose invisible boundary the ray passed before it was mirrored or refracted, or none. */
    private int passedFirst;

    /** Whether it passed that where it was aimed. */
    private boolean isPassedOnTarget;

    /** @param initialHits null if all rays are let through */
    LightTracer(ForwardPlan plan, StopSignal stop, InitialHits initialHits) {
        super(plan.index(), plan.rules());
        this.plan = plan;
        this.stop = stop;
        this.initialHits = initialHits;
    }

    ForwardPlan plan() {
        return plan;
    }

    boolean isStopped() {
        return stop.isSet();
    }

    /** Says where what the next rays bring is kept, and where it is counted. */
    void startTask(PhotonSlice slice, EnergyLedger taskLedger, ForwardCounters taskCounters) {
        photons = slice;
        ledger = taskLedger;
        counters = taskCounters;
    }

    /** @return the number of photons that came of the ray */
    int shoot(Beam from, LightPoint point, LightRay aimed, double share, boolean store) {
        beam = from;
        primary = aimed;
        isStoring = store;
        stored = 0;
        passedFirst = SceneIndex.NONE;
        beam.light().emit(point, primary.directionX, primary.directionY, primary.directionZ, flux);
        if (plan.isWeighted()) {
            flux.scale(primary.measure * share);
        }
        counters.primaryRays++;
        if (flux.isBlack() || comesThroughEndless()) {
            return 0;
        }
        // From the ray itself, so that it does not matter who sends it, nor at which scale.
        roulette.start(
                plan.seed(),
                digits(primary.directionX) ^ digits(primary.originX) ^ Long.rotateLeft(digits(primary.directionY), 24),
                digits(primary.directionZ) ^ digits(primary.originZ) ^ Long.rotateLeft(digits(primary.originY), 24));
        ray.set(
                primary.originX,
                primary.originY,
                primary.originZ,
                primary.directionX,
                primary.directionY,
                primary.directionZ);
        long testsBefore = tests();
        followAll(beam.mediaAtLight(), stop);
        counters.intersectionTests += tests() - testsBefore;
        return stored;
    }

    /** Whether parallel rays, which come from beyond all bounds, meet something without bounds before they start. */
    private boolean comesThroughEndless() {
        for (int object : beam.endlessObjects()) {
            upstream.set(
                    primary.originX,
                    primary.originY,
                    primary.originZ,
                    -primary.directionX,
                    -primary.directionY,
                    -primary.directionZ);
            if (plan.index().object(object).shape().occludes(upstream)) {
                return true;
            }
        }
        return false;
    }

    /** The bits of a number that scaling by a power of two does not change. */
    private static long digits(double value) {
        return Double.doubleToLongBits(value) & 0x800FFFFFFFFFFFFFL;
    }

    @Override
    protected boolean arrive(int object, int side) {
        counters.hits++;
        if (depth > 0) {
            land(object, side);
            return true;
        }
        counters.primaryHits++;
        boolean isFirst = passedFirst == SceneIndex.NONE;
        if (isFirst ? !isOnTarget(object) : !isPassedOnTarget) {
            // Another ray sends this light: the one at what is met first.
            return false;
        }
        if (isFirst && !isSpecular()) {
            bookStart();
            book(EnergyLedger::absorb, throughput.red, throughput.green, throughput.blue);
            return false;
        }
        if (!beam.window().owns(isFirst ? object : passedFirst)) {
            // The window of that object sends this light.
            return false;
        }
        bookStart();
        if (initialHits != null && !initialHits.admit(object, hit.x, hit.y, hit.z)) {
            book(EnergyLedger::cut, throughput.red, throughput.green, throughput.blue);
            return false;
        }
        if (isFirst) {
            keepRest(false);
        } else {
            land(object, side);
        }
        return true;
    }

    /** Shadow rays end at boundaries that light does not see: who meets one first sends what goes through it. */
    @Override
    protected void passes(int object) {
        if (depth == 0 && passedFirst == SceneIndex.NONE) {
            passedFirst = object;
            isPassedOnTarget = isOnTarget(object);
        }
    }

    private boolean isOnTarget(int object) {
        return primary.targetObject == SceneIndex.NONE
                || (primary.targetObject == object
                        && Math.abs(pathLength - primary.targetDistance) <= primary.targetError);
    }

    private boolean isSpecular() {
        return !scattering.reflectance.isBlack()
                || !scattering.transmittance.isBlack()
                || !surface.transparency.isBlack();
    }

    /** Stores what reaches a diffuse surface over a specular one. */
    private void land(int object, int side) {
        part.set(flux).multiply(throughput);
        // No photon without power: it would count among the nearest.
        boolean isStored = !surface.diffuse.isBlack() && !part.isBlack();
        if (isStored) {
            stored++;
            if (isStoring) {
                store(object, side);
            }
        }
        keepRest(isStored);
    }

    /** Stores {@link #part}. */
    private void store(int object, int side) {
        at.x = hit.x;
        at.y = hit.y;
        at.z = hit.z;
        at.normalX = side * hit.normalX;
        at.normalY = side * hit.normalY;
        at.normalZ = side * hit.normalZ;
        at.object = object;
        at.front = side > 0;
        double cosine = -(ray.directionX * at.normalX + ray.directionY * at.normalY + ray.directionZ * at.normalZ);
        part.scale(depositFactor(cosine));
        photons.add(at, part);
        counters.stored++;
    }

    /** Without weights the rays' density says nothing of distance and angle, so the photon itself must. */
    private double depositFactor(double cosine) {
        double factor = beam.light().depositFactor(pathLength);
        if (plan.isWeighted()) {
            return factor;
        }
        boolean fallsOff = beam.light().spread() == Light.Spread.FROM_POINT;
        return cosine * (fallsOff ? factor / (pathLength * pathLength) : factor);
    }

    /** Books the flux that neither goes on mirrored nor refracted. */
    private void keepRest(boolean isStored) {
        Rgb r = scattering.reflectance;
        Rgb t = scattering.transmittance;
        double red = throughput.red * (1 - r.red - t.red);
        double green = throughput.green * (1 - r.green - t.green);
        double blue = throughput.blue * (1 - r.blue - t.blue);
        if (isStored) {
            book(EnergyLedger::store, red, green, blue);
        } else {
            book(EnergyLedger::absorb, red, green, blue);
        }
    }

    /** Before the first surface it is not known whether the ray counts: {@link #bookStart} makes up for it. */
    @Override
    protected void absorbed(double red, double green, double blue) {
        if (depth > 0) {
            book(
                    EnergyLedger::absorb,
                    throughput.red * (1 - red),
                    throughput.green * (1 - green),
                    throughput.blue * (1 - blue));
        }
    }

    /** Books a ray that counts, and what media absorbed on its way to the first surface. */
    private void bookStart() {
        book(EnergyLedger::emit, 1, 1, 1);
        book(EnergyLedger::absorb, 1 - throughput.red, 1 - throughput.green, 1 - throughput.blue);
    }

    @Override
    protected void end() {
        if (depth == 0) {
            if (primary.targetObject != SceneIndex.NONE) {
                // It went by the very edge of what it was aimed at: by rounding only.
                return;
            }
            bookStart();
        }
        book(EnergyLedger::escape, throughput.red, throughput.green, throughput.blue);
    }

    /**
     * Follows weak light only now and then, but then as much of it as was left out meanwhile [Arvo and Kirk 1990]. So
     * photons are about equal, none is followed in vain, and nothing is lost on average; the ledger's cut has the
     * difference.
     */
    @Override
    protected boolean survives(Rgb fraction, double largest) {
        double weak = plan.rouletteThroughput();
        if (largest >= weak) {
            return true;
        }
        boolean survives = roulette.nextDouble() * weak < largest;
        double factor = survives ? weak / largest : 0;
        book(
                EnergyLedger::cut,
                fraction.red * (1 - factor),
                fraction.green * (1 - factor),
                fraction.blue * (1 - factor));
        fraction.scale(factor);
        return survives;
    }

    @Override
    protected void cut(Rgb fraction) {
        book(EnergyLedger::cut, fraction.red, fraction.green, fraction.blue);
    }

    @Override
    protected void spoiled() {
        counters.nonFinite++;
    }

    @Override
    protected void goesOn(boolean refracted) {
        counters.secondaryRays++;
    }

    /** Books a part of the ray's flux. */
    private void book(Entry entry, double red, double green, double blue) {
        if (isStoring) {
            part.set(flux).multiply(red, green, blue);
            entry.book(ledger, part);
        }
    }

    private interface Entry {
        void book(EnergyLedger ledger, Rgb flux);
    }
}
