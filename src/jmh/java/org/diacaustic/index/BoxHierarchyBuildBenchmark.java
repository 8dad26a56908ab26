package org.diacaustic.index;

import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** The time to build a tree over the boxes of a wavy sheet of small triangles. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
public class BoxHierarchyBuildBenchmark {
    @Param({"131072", "250000"})
    public int size;

    private double[] boxes;

    @Setup
    public void setUp() {
        SplittableRandom random = new SplittableRandom(7);
        int side = (int) Math.ceil(Math.sqrt(size));
        double width = 2.0 / side;
        boxes = new double[6 * size];
        for (int i = 0; i < size; i++) {
            double x = i % side * width;
            double z = i / side * width;
            double y = 0.1 * Math.sin(9 * x + 2 * z) + 0.05 * Math.sin(17 * z - 5 * x);
            boxes[6 * i] = x;
            boxes[6 * i + 1] = y;
            boxes[6 * i + 2] = z;
            boxes[6 * i + 3] = x + width;
            boxes[6 * i + 4] = y + width * random.nextDouble();
            boxes[6 * i + 5] = z + width;
        }
    }

    @Benchmark
    public BoxHierarchy build() {
        return BoxHierarchy.over(boxes);
    }
}
