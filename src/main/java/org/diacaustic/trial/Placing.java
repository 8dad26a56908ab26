package org.diacaustic.trial;

import org.diacaustic.math.Vector3;

/**
 * Where and how large a scene is built: all its lengths are multiplied by a factor, and then all of it is moved.
 *
 * @param scale positive
 * @param offset in scene units
 */
record Placing(double scale, Vector3 offset) {
    private static final double GRID = 0x1p20;

    static final Placing HOME = new Placing(1, Vector3.ZERO);

    static Placing scaled(double scale) {
        return new Placing(scale, Vector3.ZERO);
    }

    /** Moved by so much on every axis. */
    static Placing moved(double by) {
        return new Placing(1, new Vector3(by, by, by));
    }

    /** The place of a point, which is rounded first, so that moving it far rounds no more: the scene there is the very same. */
    Vector3 point(double x, double y, double z) {
        return new Vector3(onGrid(x), onGrid(y), onGrid(z)).times(scale).plus(offset);
    }

    Vector3 point(Vector3 point) {
        return point(point.x(), point.y(), point.z());
    }

    private static double onGrid(double coordinate) {
        return Math.rint(coordinate * GRID) / GRID;
    }

    double length(double length) {
        return length * scale;
    }

    /** Of what is counted per length, such as absorption and wave numbers. */
    double perLength(double value) {
        return value / scale;
    }

    /** The phase of a wave along a unit direction, so that it is the same wave in the same place of the scene. */
    double phase(double phase, double waveNumber, Vector3 direction) {
        return StrictMath.IEEEremainder(phase - perLength(waveNumber) * direction.dot(offset), 2 * Math.PI);
    }
}
