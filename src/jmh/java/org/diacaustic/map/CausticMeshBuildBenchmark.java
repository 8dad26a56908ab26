package org.diacaustic.map;

import java.util.concurrent.TimeUnit;
import org.diacaustic.parallel.Workers;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** The time to move cells of a caustic from their store into a mesh. */
@State(Scope.Thread)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 5)
@Measurement(iterations = 7)
public class CausticMeshBuildBenchmark {
    @Param({"65536", "262144", "1000000"})
    public int cells;

    @Param({"1", "2"})
    public int threads;

    private CellStore store;

    @Setup(Level.Iteration)
    public void setUp() {
        store = CausticCells.store(cells);
    }

    @Benchmark
    public CausticMesh build() {
        return CausticMesh.movedFrom(store, new Workers(threads));
    }
}
