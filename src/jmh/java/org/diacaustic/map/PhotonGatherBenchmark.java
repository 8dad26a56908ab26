package org.diacaustic.map;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** The time to gather photons of a caustic at a point, through the filter: within a radius that holds 112, or the 50 nearest. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class PhotonGatherBenchmark {
    @Param({"1000000"})
    public int size;

    @Param({"ARRANGED", "LEFT_BALANCED", "OBJECT_TREE", "HASH_GRID"})
    public IndexKind kind;

    /** Row by row, or shuffled. */
    @Param({"false", "true"})
    public boolean shuffled;

    private SurfacePoint[] points;
    private GatherQuery query;
    private double radius;
    private int next;

    @Setup
    public void setUp() {
        points = CausticPhotons.queries(100_000, shuffled);
        radius = CausticPhotons.radiusFor(112, size);
        PhotonIndex index = kind.build(CausticPhotons.store(size), radius);
        query = index.query(PhotonFilter.TWO_SIDED_NORMAL);
    }

    @Benchmark
    public double within() {
        query.within(nextPoint(), radius);
        return query.sum.red;
    }

    @Benchmark
    public double nearest() {
        query.nearest(nextPoint(), 50, Double.POSITIVE_INFINITY);
        return query.sum.red;
    }

    private SurfacePoint nextPoint() {
        next = next + 1 < points.length ? next + 1 : 0;
        return points[next];
    }
}
