package org.diacaustic.trial;

import java.util.Arrays;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.descriptive.rank.Percentile;
import org.apache.commons.math3.stat.regression.SimpleRegression;
import org.diacaustic.map.Estimator;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.map.Kernel;
import org.diacaustic.map.PhotonFilter;
import org.diacaustic.map.PhotonMap;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;

/**
 * A progressive render of many like places at once: around each the irradiance is 1 + c·ρ², ρ the distance, so that a disc of
 * radius r finds c·r²/2 too much and nothing else.
 */
final class ProgressivePasses {
    private static final int PLACES = 128;

    /** Places are so far apart, each amid a square of side 2: the first radius is 1. */
    private static final double SPACING = 4;

    /** On average, so that counts are like those of Poisson. */
    private static final int PHOTONS_A_PLACE = 24;

    /** A quarter of a decade apart, two decades in all. */
    private static final int[] COUNTS = {50, 89, 158, 281, 500, 889, 1581, 2812, 5000};

    private static final int BOOTSTRAPS = 1000;

    private final double alpha;

    /** c: the term of the squared error that shrinks more slowly must not be the smaller one at first. */
    private final double rise;

    private final SplittableRandom random = new SplittableRandom(1);

    /** For each of the numbers of passes, how far off the mean is at each place. */
    private final double[][] errors = new double[COUNTS.length][PLACES];

    ProgressivePasses(double alpha) {
        this.alpha = alpha;
        this.rise = 0.4 * StrictMath.exp(5 * (alpha - 2.0 / 3));
    }

    /** Runs all passes. */
    void run() {
        double[] sums = new double[PLACES];
        int next = 0;
        for (int pass = 1; next < COUNTS.length; pass++) {
            addPass(pass, sums);
            if (pass == COUNTS[next]) {
                for (int place = 0; place < PLACES; place++) {
                    errors[next][place] = sums[place] / pass - 1;
                }
                next++;
            }
        }
    }

    private void addPass(int pass, double[] sums) {
        // The integral of 1 + c(x² + z²) over the square is 4(1 + 2c/3).
        double power = 4 * (1 + rise * 2 / 3) / PHOTONS_A_PLACE;
        double middle = SPACING * (PLACES - 1) / 2;
        StoredPhotons photons = new StoredPhotons(new Vector3(middle, 0, 0), middle, PLACES * PHOTONS_A_PLACE, power);
        for (int i = 0; i < PLACES * PHOTONS_A_PLACE; i++) {
            addPhoton(SPACING * random.nextInt(PLACES), photons);
        }
        double radius = Estimator.progressiveRadius(1, pass, alpha);
        IlluminationMap.Lookup lookup = PhotonMap.over(
                        photons.tree(), new Estimator.Density(radius, Kernel.CONSTANT), PhotonFilter.TWO_SIDED_NORMAL)
                .lookup();
        Rgb irradiance = new Rgb();
        for (int place = 0; place < PLACES; place++) {
            lookup.irradiance(StoredPhotons.floor(SPACING * place, 0), irradiance);
            sums[place] += irradiance.green;
        }
    }

    private void addPhoton(double place, StoredPhotons photons) {
        double x;
        double z;
        do {
            x = random.nextDouble(-1, 1);
            z = random.nextDouble(-1, 1);
        } while (random.nextDouble() * (1 + 2 * rise) > 1 + rise * (x * x + z * z));
        photons.add(StoredPhotons.floor(place + x, z));
    }

    /** The 95 % interval of the power of the number of passes with which a measure goes. */
    double[] exponent(Measure measure) {
        SplittableRandom choice = new SplittableRandom(2);
        double[] exponents = new double[BOOTSTRAPS];
        for (int i = 0; i < BOOTSTRAPS; i++) {
            int[] places =
                    IntStream.range(0, PLACES).map(k -> choice.nextInt(PLACES)).toArray();
            SimpleRegression line = new SimpleRegression();
            for (int k = 0; k < COUNTS.length; k++) {
                double[] chosen = errors[k];
                Sample sample = Sample.of(Arrays.stream(places)
                        .mapToDouble(place -> chosen[place])
                        .toArray());
                line.addData(Math.log(COUNTS[k]), Math.log(measure.of(sample)));
            }
            exponents[i] = line.getSlope();
        }
        Percentile percentile = new Percentile();
        percentile.setData(exponents);
        return new double[] {percentile.evaluate(2.5), percentile.evaluate(97.5)};
    }

    /** What shrinks with the number of passes. */
    enum Measure {
        VARIANCE {
            @Override
            double of(Sample errors) {
                return errors.deviation() * errors.deviation();
            }
        },
        BIAS {
            @Override
            double of(Sample errors) {
                return Math.abs(errors.mean());
            }
        },
        MSE {
            @Override
            double of(Sample errors) {
                return errors.mean() * errors.mean() + errors.deviation() * errors.deviation();
            }
        };

        abstract double of(Sample errors);

        String exponentName() {
            return name().toLowerCase(Locale.ROOT) + "_exponent";
        }
    }
}
