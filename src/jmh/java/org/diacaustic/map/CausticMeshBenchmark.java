package org.diacaustic.map;

import java.util.concurrent.TimeUnit;
import org.diacaustic.math.Rgb;
import org.diacaustic.parallel.Workers;
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

/** The time to ask a mesh of a caustic about a pixel, row by row: about 30 small triangles in each, or few large ones. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class CausticMeshBenchmark {
    @Param({"65536", "1000000"})
    public int cells;

    /** The pixels in a row of the picture. */
    @Param({"256", "1024"})
    public int side;

    private Footprint[] pixels;
    private FootprintLookup lookup;
    private final SurfacePoint at = new SurfacePoint();
    private final Rgb irradiance = new Rgb();
    private int next;

    @Setup
    public void setUp() {
        pixels = CausticCells.pixels(side);
        lookup =
                CausticMesh.movedFrom(CausticCells.store(cells), new Workers(2)).lookup();
    }

    @Benchmark
    public double query() {
        next = next + 1 < pixels.length ? next + 1 : 0;
        lookup.irradiance(pixels[next], at, irradiance);
        return irradiance.red;
    }
}
