package org.diacaustic.study;

import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.distribution.FDistribution;
import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.stat.regression.SimpleRegression;

/**
 * A straight line through logarithms: y falls like x to a power.
 *
 * @param power not a number if there are fewer than two different x
 * @param interval holds the true power with a chance of 95 %, if there is one; unknown if there are fewer than three points
 * @param decades of x that the points span
 * @param points that it was fitted to
 */
public record PowerFit(double power, Interval interval, double decades, int points) {
    private static final double UPPER = 0.975;

    /** Chance of calling a true power none. */
    private static final double LEVEL = 0.05;

    /**
     * Fits the line by least squares; the interval is Student's. Points with a number that is not positive or not finite are
     * left out.
     *
     * @param x as many as y
     */
    static PowerFit of(double[] x, double[] y) {
        Logarithms logarithms = Logarithms.of(x, y);
        return fit(logarithms, logarithms.regression());
    }

    /**
     * Fits one line to groups of points, each group the runs of one budget. Runs tell how much is chance. If the groups lie off
     * the line by more than that explains (F test for lack of fit, level 5 %), y is no power of x, and many runs would make the
     * interval narrow around a slope that is but a mean of different ones. Then the groups are what scatters: the interval is
     * Student's of their means, which has as many degrees of freedom as there are groups, less two. So an interval is never
     * narrower for being made of many runs than the bend of the law allows.
     *
     * @param x a row a group
     * @param y the same
     */
    static PowerFit ofGroups(List<double[]> x, List<double[]> y) {
        Logarithms all = Logarithms.of(joined(x), joined(y));
        SimpleRegression line = all.regression();
        PowerFit plain = fit(all, line);
        double within = 0;
        double between = 0;
        int groups = 0;
        double[] meanX = new double[x.size()];
        double[] meanY = new double[x.size()];
        for (int i = 0; i < x.size(); i++) {
            Logarithms group = Logarithms.of(x.get(i), y.get(i));
            if (group.count() > 0) {
                double[] off = group.offLine(line);
                double mean = Distribution.mean(off);
                within += Arrays.stream(off)
                        .map(each -> (each - mean) * (each - mean))
                        .sum();
                between += group.count() * mean * mean;
                meanX[groups] = Distribution.mean(group.x());
                meanY[groups] = Distribution.mean(group.y());
                groups++;
            }
        }
        int freedomBetween = groups - 2;
        int freedomWithin = all.count() - groups;
        if (freedomBetween < 1 || freedomWithin < 1 || Double.isNaN(plain.power)) {
            return plain;
        }
        double quotient = between / freedomBetween / (within / freedomWithin);
        // Runs without any chance make the quotient infinite, or 0/0 if they are exactly on the line.
        double chance = Double.isInfinite(quotient)
                ? 0
                : 1 - new FDistribution(null, freedomBetween, freedomWithin).cumulativeProbability(quotient);
        if (!(chance < LEVEL)) {
            return plain;
        }
        Logarithms means = new Logarithms(Arrays.copyOf(meanX, groups), Arrays.copyOf(meanY, groups));
        PowerFit bent = fit(means, means.regression());
        return new PowerFit(plain.power, around(plain.power, bent.interval), plain.decades, plain.points);
    }

    private static Interval around(double power, Interval interval) {
        double half = (interval.high() - interval.low()) / 2;
        return new Interval(power - half, power + half);
    }

    private static PowerFit fit(Logarithms points, SimpleRegression line) {
        double power = line.getSlope();
        int count = points.count();
        if (count < 3 || Double.isNaN(power)) {
            return new PowerFit(power, Interval.UNKNOWN, points.decades(), count);
        }
        double half = new TDistribution(null, count - 2).inverseCumulativeProbability(UPPER) * line.getSlopeStdErr();
        return new PowerFit(power, new Interval(power - half, power + half), points.decades(), count);
    }

    private static double[] joined(List<double[]> rows) {
        return rows.stream().flatMapToDouble(Arrays::stream).toArray();
    }

    /** Natural logarithms of points. */
    private record Logarithms(double[] x, double[] y) {

        static Logarithms of(double[] x, double[] y) {
            double[] logX = new double[x.length];
            double[] logY = new double[x.length];
            int count = 0;
            for (int i = 0; i < x.length; i++) {
                if (isPositive(x[i]) && isPositive(y[i])) {
                    logX[count] = Math.log(x[i]);
                    logY[count] = Math.log(y[i]);
                    count++;
                }
            }
            return new Logarithms(Arrays.copyOf(logX, count), Arrays.copyOf(logY, count));
        }

        private static boolean isPositive(double value) {
            return value > 0 && value < Double.POSITIVE_INFINITY;
        }

        int count() {
            return x.length;
        }

        SimpleRegression regression() {
            SimpleRegression line = new SimpleRegression();
            for (int i = 0; i < x.length; i++) {
                line.addData(x[i], y[i]);
            }
            return line;
        }

        double[] offLine(SimpleRegression line) {
            double[] off = new double[x.length];
            for (int i = 0; i < off.length; i++) {
                off[i] = y[i] - line.predict(x[i]);
            }
            return off;
        }

        double decades() {
            double least = Arrays.stream(x).min().orElse(0);
            double most = Arrays.stream(x).max().orElse(0);
            return (most - least) / Math.log(10);
        }
    }
}
