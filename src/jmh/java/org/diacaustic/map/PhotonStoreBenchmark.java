package org.diacaustic.map;

import java.util.concurrent.TimeUnit;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** The time to store one photon, in slices of 1000 that are appended, when the pool is filled. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class PhotonStoreBenchmark {
    private static final int PHOTONS = 100_000;
    private static final int SLICE = 1000;

    private final PhotonStore store = new PhotonStore(Vector3.ZERO, 1, PHOTONS);
    private final PhotonSlice slice = store.slice();
    private final Rgb power = new Rgb().set(1, 0.9, 0.8);
    private SurfacePoint[] points;

    @Setup
    public void setUp() {
        points = CausticPhotons.queries(PHOTONS, false);
    }

    @Benchmark
    @OperationsPerInvocation(PHOTONS)
    public int add() {
        store.clear();
        for (int i = 0; i < PHOTONS; i++) {
            slice.add(points[i % points.length], power);
            if (slice.size() == SLICE) {
                store.append(slice);
            }
        }
        return store.size();
    }
}
