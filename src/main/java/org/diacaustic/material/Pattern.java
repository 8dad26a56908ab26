package org.diacaustic.material;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.shape.Hit;

/**
 * A number in 0..1 for every point of a surface: the share of the second of two colours. Patterns in space are cut out
 * of a block in scene coordinates; the others lie on the surface's map.
 */
public sealed interface Pattern {

    double at(Hit hit);

    default boolean needsMap() {
        return false;
    }

    /** Alternating cubes of the given edge, in scene units. */
    record Checker(double size) implements Pattern {
        public Checker {
            requirePositive(size, "size");
        }

        @Override
        public double at(Hit hit) {
            double sum = cell(hit.x) + cell(hit.y) + cell(hit.z);
            return sum - 2 * Math.floor(sum / 2);
        }

        private double cell(double coordinate) {
            // Half a cell aside, so that a floor at height 0 does not flicker between two layers.
            return Math.floor(coordinate / size + 0.5);
        }
    }

    /** Alternating fields of the map: {@code columns} in u and {@code rows} in v. */
    record MapChecker(int columns, int rows) implements Pattern {
        public MapChecker {
            if (columns < 1 || rows < 1) {
                throw new IllegalArgumentException(
                        "a checker needs at least 1 column and 1 row, but has " + columns + " and " + rows);
            }
        }

        @Override
        public double at(Hit hit) {
            long sum = (long) Math.floor(hit.u * columns) + (long) Math.floor(hit.v * rows);
            return Math.floorMod(sum, 2L);
        }

        @Override
        public boolean needsMap() {
            return true;
        }
    }

    /** Soft bands along a direction, one of each colour per {@code length} scene units. */
    record Stripes(org.diacaustic.math.Vector3 direction, double length) implements Pattern {
        public Stripes {
            direction = direction.normalized();
            requirePositive(length, "length");
        }

        @Override
        public double at(Hit hit) {
            double along = direction.x() * hit.x + direction.y() * hit.y + direction.z() * hit.z;
            return 0.5 - 0.5 * StrictMath.cos(2 * Math.PI * along / length);
        }
    }

    /** Veined stone: bands along y, {@code size} scene units apart, displaced by turbulence. */
    record Marble(double size, double turbulence) implements Pattern {
        public Marble {
            requirePositive(size, "size");
            if (!(turbulence >= 0 && turbulence < Double.POSITIVE_INFINITY)) {
                throw new IllegalArgumentException("turbulence must be at least 0, but is " + turbulence);
            }
        }

        @Override
        public double at(Hit hit) {
            double x = hit.x / size;
            double y = hit.y / size;
            double z = hit.z / size;
            double displaced = y + turbulence * GradientNoise.turbulence(x, y, z, 5);
            return 0.5 - 0.5 * StrictMath.cos(2 * Math.PI * displaced);
        }
    }

    /** Clouds: a sum of gradient noises whose largest features are {@code size} scene units across. */
    record Clouds(double size) implements Pattern {
        public Clouds {
            requirePositive(size, "size");
        }

        @Override
        public double at(Hit hit) {
            double noise = GradientNoise.turbulence(hit.x / size, hit.y / size, hit.z / size, 5);
            return Arithmetic.clamp(0.5 + 0.5 * noise, 0, 1);
        }
    }

    private static void requirePositive(double value, String what) {
        if (!(value > 0 && value < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(what + " must be positive and finite, but is " + value);
        }
    }
}
