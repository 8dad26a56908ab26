package org.diacaustic.preprocess;

import org.diacaustic.light.LightPoint;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Rgb;
import org.diacaustic.parallel.StopSignal;

/** Follows light rays with all their branches, and notes where each lands: the corners of cells. Owned by one task. */
final class LeafTracer extends LightPathTracer {
    static final int EMITTED = 0;
    static final int STORED = 1;
    static final int ABSORBED = 2;
    static final int ESCAPED = 3;
    static final int CUT = 4;

    /** Light that carries a smaller fraction of its ray's flux is not followed, unless the settings follow everything. */
    private static final double LEAST_THROUGHPUT = 0x1p-11;

    private static final double LEAST_IMPORTANCE = 0x1p-5;

    private final ForwardPlan plan;
    private final SurfacePoint at = new SurfacePoint();
    private final Rgb flux = new Rgb();
    private final Rgb power = new Rgb();
    private LeafTable table;
    private ForwardCounters counters;
    private double least;

    LeafTracer(ForwardPlan plan, StopSignal stop) {
        super(plan.index(), plan.rules(), stop);
        this.plan = plan;
    }

    /** Says where the next rays are noted and counted. */
    void startTask(LeafTable leaves, ForwardCounters taskCounters) {
        table = leaves;
        counters = taskCounters;
    }

    /**
     * Follows a ray from a point of the beam's light, and gives its number in the table.
     *
     * @param importance how much of light space it stands for, compared with others: of those that stand for little, parts
     *     are given up the sooner
     */
    int trace(Beam from, LightPoint point, LightRay primary, double importance) {
        int number = table.startRay();
        least = plan.rouletteThroughput() > 0 ? LEAST_THROUGHPUT / Math.max(LEAST_IMPORTANCE, importance) : 0;
        from.light().emit(point, primary.directionX, primary.directionY, primary.directionZ, flux);
        counters.primaryRays++;
        if (!flux.isBlack()) {
            long testsBefore = tests();
            follow(from, primary);
            counters.intersectionTests += tests() - testsBefore;
        }
        return number;
    }

    @Override
    protected void meets() {
        counters.hits++;
        counters.primaryHits += depth == 0 ? 1 : 0;
    }

    @Override
    protected void starts(Rgb lost) {
        table.book(EMITTED, flux.sum());
        takes(lost);
    }

    @Override
    protected void staysDirect() {
        book(ABSORBED, throughput.red, throughput.green, throughput.blue);
    }

    @Override
    protected boolean enters(int object) {
        return true;
    }

    @Override
    protected void lands(int object, int side) {
        power.set(flux).multiply(throughput);
        boolean isStored = !surface.diffuse.isBlack() && !power.isBlack();
        if (isStored) {
            at.x = hit.x;
            at.y = hit.y;
            at.z = hit.z;
            at.normalX = side * hit.normalX;
            at.normalY = side * hit.normalY;
            at.normalZ = side * hit.normalZ;
            at.object = object;
            at.front = side > 0;
            power.scale(beam().light().depositFactor(pathLength));
            table.addLeaf(signatureAt(object, side), throughput.largest(), at, power);
        }
        bookRest(isStored ? STORED : ABSORBED);
    }

    @Override
    protected void keepsRest() {
        bookRest(ABSORBED);
    }

    /** Books what neither goes on mirrored nor refracted. */
    private void bookRest(int account) {
        Rgb r = scattering.reflectance;
        Rgb t = scattering.transmittance;
        book(
                account,
                throughput.red * (1 - r.red - t.red),
                throughput.green * (1 - r.green - t.green),
                throughput.blue * (1 - r.blue - t.blue));
    }

    @Override
    protected void takes(Rgb lost) {
        book(ABSORBED, lost.red, lost.green, lost.blue);
    }

    @Override
    protected void escapes() {
        book(ESCAPED, throughput.red, throughput.green, throughput.blue);
    }

    @Override
    protected boolean survives(long path, Rgb fraction, double largest) {
        if (largest >= least) {
            return true;
        }
        cut(fraction);
        return false;
    }

    @Override
    protected void cut(Rgb fraction) {
        book(CUT, fraction.red, fraction.green, fraction.blue);
    }

    @Override
    protected void spoiled() {
        counters.nonFinite++;
    }

    @Override
    protected void goesOn(boolean refracted) {
        counters.secondaryRays++;
    }

    private void book(int account, double red, double green, double blue) {
        table.book(account, flux.red * red + flux.green * green + flux.blue * blue);
    }
}
