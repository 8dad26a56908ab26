package org.diacaustic.map;

import java.util.List;
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

/** The time to make a footprint of a pixel and to ask a mesh of a caustic about it, row by row. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class CausticMeshBenchmark {
    @Param({"65536", "262144", "1000000"})
    public int cells;

    /** The pixels in a row of the picture. */
    @Param({"256", "1024"})
    public int side;

    private List<CausticCells.Pixel> pixels;
    private FootprintLookup lookup;
    private final Footprint footprint = new Footprint();
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
        next = next + 1 < pixels.size() ? next + 1 : 0;
        CausticCells.Pixel pixel = pixels.get(next);
        pixel.fill(footprint);
        footprint.close();
        lookup.irradiance(footprint, pixel.at(), irradiance);
        return irradiance.red;
    }
}
