package org.diacaustic.preprocess;

/** What all forward passes of a render did together. */
public final class ForwardTotals {
    private final ForwardCounters counters = new ForwardCounters();
    private final EnergyLedger ledger = new EnergyLedger();
    private long mapBytes;
    private double gatherRadius;
    private double traceSeconds;
    private double buildSeconds;

    /** Adds a pass and the map that was built of it. */
    public void add(
            ForwardCounters counted, EnergyLedger booked, long bytes, double secondsToTrace, double secondsToBuild) {
        counters.add(counted);
        ledger.add(booked);
        mapBytes = Math.max(mapBytes, bytes);
        traceSeconds += secondsToTrace;
        buildSeconds += secondsToBuild;
    }

    public ForwardCounters counters() {
        return counters;
    }

    public EnergyLedger ledger() {
        return ledger;
    }

    /** Notes the radius of {@link MapBuilder#gatherRadius()}. */
    public void noteGatherRadius(double radius) {
        gatherRadius = radius;
    }

    /** How far the first pass' photons were looked for, in scene units; 0 if none were looked for so. */
    public double gatherRadius() {
        return gatherRadius;
    }

    /** The memory that the largest map took. */
    public long mapBytes() {
        return mapBytes;
    }

    /** Wall clock of following light rays. */
    public double traceSeconds() {
        return traceSeconds;
    }

    /** Wall clock of making maps of what they brought. */
    public double buildSeconds() {
        return buildSeconds;
    }
}
