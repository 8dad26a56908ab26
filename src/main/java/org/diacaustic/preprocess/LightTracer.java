package org.diacaustic.preprocess;

import org.diacaustic.light.Light;
import org.diacaustic.light.LightPoint;
import org.diacaustic.map.InitialHits;
import org.diacaustic.map.PhotonSlice;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.SampleStream;
import org.diacaustic.parallel.StopSignal;

/** Stores a photon at every diffuse surface that light rays reach after they were mirrored or refracted. */
final class LightTracer extends LightPathTracer {
    private final ForwardPlan plan;
    /** Null unless areas of refracting objects let only some rays through. */
    private final InitialHits initialHits;

    private final SampleStream roulette = new SampleStream();
    private final SurfacePoint at = new SurfacePoint();
    private final Rgb flux = new Rgb();
    private final Rgb part = new Rgb();
    private PhotonSlice photons;
    private EnergyLedger ledger;
    private ForwardCounters counters;
    private boolean isStoring;
    private int stored;

    /** @param initialHits null if all rays are let through */
    LightTracer(ForwardPlan plan, StopSignal stop, InitialHits initialHits) {
        super(plan.index(), plan.rules(), stop);
        this.plan = plan;
        this.initialHits = initialHits;
    }

    ForwardPlan plan() {
        return plan;
    }

    /** Says where what the next rays bring is kept, and where it is counted. */
    void startTask(PhotonSlice slice, EnergyLedger taskLedger, ForwardCounters taskCounters) {
        photons = slice;
        ledger = taskLedger;
        counters = taskCounters;
    }

    /** @return the number of photons that came of the ray */
    int shoot(Beam from, LightPoint point, LightRay primary, double share, boolean store) {
        isStoring = store;
        stored = 0;
        from.light().emit(point, primary.directionX, primary.directionY, primary.directionZ, flux);
        if (plan.isWeighted()) {
            flux.scale(primary.measure * share);
        }
        counters.primaryRays++;
        if (flux.isBlack()) {
            return 0;
        }
        // From the ray itself, so that it does not matter who sends it, nor at which scale.
        roulette.start(
                plan.seed(),
                digits(primary.directionX) ^ digits(primary.originX) ^ Long.rotateLeft(digits(primary.directionY), 24),
                digits(primary.directionZ) ^ digits(primary.originZ) ^ Long.rotateLeft(digits(primary.originY), 24));
        long testsBefore = tests();
        follow(from, primary);
        counters.intersectionTests += tests() - testsBefore;
        return stored;
    }

    /** The bits of a number that scaling by a power of two does not change. */
    private static long digits(double value) {
        return Double.doubleToLongBits(value) & 0x800FFFFFFFFFFFFFL;
    }

    @Override
    protected void meets() {
        counters.hits++;
        counters.primaryHits += depth == 0 ? 1 : 0;
    }

    @Override
    protected void staysDirect() {
        book(EnergyLedger::absorb, throughput.red, throughput.green, throughput.blue);
    }

    @Override
    protected boolean enters(int object) {
        if (initialHits != null && !initialHits.admit(object, hit.x, hit.y, hit.z)) {
            book(EnergyLedger::cut, throughput.red, throughput.green, throughput.blue);
            return false;
        }
        return true;
    }

    @Override
    protected void keepsRest() {
        keepRest(false);
    }

    /** Stores what reaches a diffuse surface over a specular one. */
    @Override
    protected void lands(int object, int side) {
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
        double factor = beam().light().depositFactor(pathLength);
        if (plan.isWeighted()) {
            return factor;
        }
        boolean fallsOff = beam().light().spread() == Light.Spread.FROM_POINT;
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

    @Override
    protected void takes(Rgb lost) {
        book(EnergyLedger::absorb, lost.red, lost.green, lost.blue);
    }

    /** Books a ray that counts, and what media absorbed on its way to the first surface. */
    @Override
    protected void starts(Rgb lost) {
        book(EnergyLedger::emit, 1, 1, 1);
        takes(lost);
    }

    @Override
    protected void escapes() {
        book(EnergyLedger::escape, throughput.red, throughput.green, throughput.blue);
    }

    /**
     * Follows weak light only now and then, but then as much of it as was left out meanwhile [Arvo and Kirk 1990]. So
     * photons are about equal, none is followed in vain, and nothing is lost on average; the ledger's cut has the
     * difference.
     */
    @Override
    protected boolean survives(long path, Rgb fraction, double largest) {
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
