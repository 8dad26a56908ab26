package org.diacaustic.preprocess;

import org.diacaustic.math.SampleStream;

/** Choices of points that stand for a light, evenly over its surface: stratified, and by van der Corput numbers. */
final class LightPoints {
    private final SampleStream random;
    private final int count;
    private final double turn;
    private int next;
    private double s = 0.5;
    private double t = 0.5;

    /** As many points as the light says. */
    LightPoints(Beam beam, SampleStream random) {
        this(beam.pointCount(), random);
    }

    /** @param random for where the points lie, asked here and at each {@link #next} */
    LightPoints(int count, SampleStream random) {
        this.random = random;
        this.count = count;
        this.turn = random.nextDouble();
    }

    /** How many points there are in all. */
    int count() {
        return count;
    }

    /** Goes to the next point; false if there are no more. */
    boolean next() {
        if (next == count) {
            return false;
        }
        if (count > 1) {
            s = (next + random.nextDouble()) / count;
            t = (reversed(next) + turn) % 1;
        }
        next++;
        return true;
    }

    /** The first coordinate of the point's choice. */
    double s() {
        return s;
    }

    /** The second coordinate. */
    double t() {
        return t;
    }

    /** The bits of k behind the binary point, in reverse order. */
    private static double reversed(int k) {
        return (Integer.reverse(k) >>> 1) * 0x1p-31;
    }
}
