package org.diacaustic.trial;

import org.diacaustic.map.Estimator;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.map.Kernel;
import org.diacaustic.map.PhotonFilter;
import org.diacaustic.map.PhotonMap;
import org.diacaustic.map.PhotonSlice;
import org.diacaustic.map.PhotonStore;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.CompensatedSum;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Long sums, and differences in which digits could be lost. */
final class SumTrials {
    /** Photons of one store; more of the same are read by looking as often. */
    private static final int MOST_STORED = 1 << 20;

    private SumTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "float_sum",
                "So many photons of that power, in W, put into a PhotonStore, in single precision, and added up in double precision by a"
                        + " lookup in a PhotonMap whose disc holds them all. Of more than 2^20 equal photons, 2^20 are stored and"
                        + " read as often as it takes, the last time fewer.",
                SumTrials::floatSum);
        operations.add(
                "compensated_sum",
                "CompensatedSum, which keeps the energy ledger. Within so many units in the last place of the answer.",
                SumTrials::compensatedSum);
        operations.add(
                "diff_of_products",
                "Arithmetic.differenceOfProducts, which discriminants, determinants and cross products ask.",
                SumTrials::differenceOfProducts);
    }

    private static void floatSum(NumericCase asked, Checks checks) {
        long count = asked.inputs().integer("N");
        double value = asked.inputs().number("value");
        if (count < 1 || !(value > 0 && value < Double.POSITIVE_INFINITY)) {
            throw new CaseFault("photons have a positive power, and there must be one, but there are " + count + " of "
                    + value + " W");
        }
        long whole = count / MOST_STORED;
        double sum = whole > 0 ? whole * storedSum(MOST_STORED, value) : 0;
        int rest = (int) (count % MOST_STORED);
        sum += rest > 0 ? storedSum(rest, value) : 0;
        double relative = asked.tolerance().number("rel_required");
        double exact = asked.expected().number("exact_of_stored_floats");
        checks.number("sum of the stored powers", exact, sum, relative * exact);
    }

    /** The sum that a lookup finds of equal photons, in W. */
    private static double storedSum(int count, double power) {
        PhotonStore store = new PhotonStore(Vector3.ZERO, Arithmetic.powerOfTwoNear(power), count);
        PhotonSlice slice = store.slice();
        SurfacePoint at = new SurfacePoint();
        at.normalY = 1;
        at.front = true;
        Rgb each = new Rgb();
        each.set(power, power, power);
        for (int i = 0; i < count; i++) {
            // On a spiral within the unit disc, so that the tree has something to divide.
            double radius = Math.sqrt((i + 0.5) / count);
            double angle = 2.399963229728653 * i;
            at.x = 0.5 * radius * StrictMath.cos(angle);
            at.z = 0.5 * radius * StrictMath.sin(angle);
            slice.add(at, each);
        }
        store.append(slice);
        IlluminationMap.Lookup lookup = PhotonMap.over(
                        store, new Estimator.Density(1, Kernel.CONSTANT), PhotonFilter.NONE, new Workers(1))
                .lookup();
        at.x = 0;
        at.z = 0;
        Rgb irradiance = new Rgb();
        lookup.irradiance(at, irradiance);
        return irradiance.green * Math.PI;
    }

    private static void compensatedSum(NumericCase asked, Checks checks) {
        CompensatedSum sum = new CompensatedSum();
        for (double value : asked.inputs().numbers("values")) {
            sum.add(value);
        }
        double expected = asked.expected().number("sum_correctly_rounded");
        double ulps = asked.tolerance().number("ulp", 1);
        checks.number("sum_correctly_rounded", expected, sum.value(), ulps * Math.ulp(expected));
    }

    private static void differenceOfProducts(NumericCase asked, Checks checks) {
        checks.number(
                "exact",
                Arithmetic.differenceOfProducts(
                        asked.inputs().number("a"),
                        asked.inputs().number("b"),
                        asked.inputs().number("c"),
                        asked.inputs().number("d")));
    }
}
