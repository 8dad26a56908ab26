package org.diacaustic.trial;

import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Values;

/** The places of photons that cases name by a word. */
final class PhotonPlaces {
    /** More are no question of arithmetic. */
    private static final long MOST = 10_000_000;

    private long state;

    private PhotonPlaces(long seed) {
        state = seed;
    }

    /** The places that {@code mode}, {@code N} and {@code lcg_seed} say, of three coordinates each. */
    static double[][] of(Values inputs) {
        long count = inputs.integer("N");
        if (count < 0 || count > MOST) {
            throw new CaseFault("inputs.N should be from 0 to " + MOST + ", but is " + count);
        }
        String mode = inputs.text("mode");
        PhotonPlaces generator = new PhotonPlaces(inputs.integer("lcg_seed"));
        int side = (int) Math.ceil(Math.cbrt(count) - 1e-9);
        IntFunction<double[]> place = switch (mode) {
            case "cube" -> i -> new double[] {generator.next(), generator.next(), generator.next()};
            case "line" -> i -> generator.diagonal();
            case "equal" -> i -> new double[] {0.5, 0.25, 0.125};
            case "two" -> i -> new double[] {i % 2 == 0 ? 0 : 0.5, 0, 0};
            case "lattice" ->
                i -> {
                    int layer = i / (side * side);
                    int row = i / side % side;
                    return new double[] {(double) layer / side, (double) row / side, i % side / (double) side};
                };
            default -> throw new CaseFault("inputs.mode: where photons lie in '" + mode + "' is not said");
        };
        return IntStream.range(0, (int) count).mapToObj(place).toArray(double[][]::new);
    }

    /** A point there that faces up. */
    static SurfacePoint at(double[] place) {
        return StoredPhotons.point(place[0], place[1], place[2], 0, 1, 0);
    }

    /** The next number of the cases' generator: 20 bits of s = 6364136223846793005 s + 1442695040888963407 modulo 2^64. */
    private double next() {
        state = state * 6364136223846793005L + 1442695040888963407L;
        return (state >>> 44) * 0x1p-20;
    }

    private double[] diagonal() {
        double along = next();
        return new double[] {along, along, along};
    }
}
