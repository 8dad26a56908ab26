package org.diacaustic.image;

import java.util.Arrays;
import org.diacaustic.math.CompensatedSum;

/** The sums behind {@link ImageMetrics}, in two passes: the mean of the reference, then the errors, block by block. */
final class ImageComparison {
    private static final int BLOCK = 8;
    private static final double OFFSET_PER_MEAN = 0.01;
    private static final int PIXELS_PER_TRIMMED = 1000;

    private final LinearImage test;
    private final LinearImage reference;
    private final ImageMask mask;

    private long compared;
    private long nonFiniteTest;
    private long nonFiniteReference;

    private final CompensatedSum squares = new CompensatedSum();
    private final CompensatedSum absolutes = new CompensatedSum();
    private final CompensatedSum differences = new CompensatedSum();
    private double[] relativeTerms;
    private int termCount;
    private double offsetSquared;
    private double worstBlock;
    private double largest;

    ImageComparison(LinearImage test, LinearImage reference, ImageMask mask) {
        this.test = test;
        this.reference = reference;
        this.mask = mask;
    }

    ImageMetrics metrics() {
        double mean = referenceMean();
        offsetSquared = OFFSET_PER_MEAN * mean * (OFFSET_PER_MEAN * mean);
        relativeTerms = new double[Math.toIntExact(compared)];
        for (int y = 0; y < test.height(); y += BLOCK) {
            for (int x = 0; x < test.width(); x += BLOCK) {
                addBlock(x, y);
            }
        }
        double count = 3.0 * compared;
        double scale = Math.abs(mean);
        double relative = mean(relativeTerms.length);
        Arrays.sort(relativeTerms);
        return new ImageMetrics(
                quotient(Math.sqrt(squares.value() / count), scale),
                quotient(absolutes.value() / count, scale),
                relative,
                mean(relativeTerms.length - relativeTerms.length / PIXELS_PER_TRIMMED),
                compared == 0 ? Double.NaN : quotient(worstBlock, scale),
                compared == 0 ? Double.NaN : largest,
                quotient(differences.value() / count, scale),
                mean,
                compared,
                nonFiniteTest,
                nonFiniteReference);
    }

    /** Counts the pixels, too. */
    private double referenceMean() {
        CompensatedSum sum = new CompensatedSum();
        float[] samples = reference.samples();
        for (int y = 0; y < test.height(); y++) {
            for (int x = 0; x < test.width(); x++) {
                if (!mask.includes(x, y)) {
                    continue;
                }
                int offset = test.offset(x, y);
                boolean finiteTest = isFinite(test.samples(), offset);
                boolean finiteReference = isFinite(samples, offset);
                nonFiniteTest += finiteTest ? 0 : 1;
                nonFiniteReference += finiteReference ? 0 : 1;
                if (finiteTest && finiteReference) {
                    compared++;
                    sum.add((double) samples[offset] + samples[offset + 1] + samples[offset + 2]);
                }
            }
        }
        return sum.value() / (3.0 * compared);
    }

    private void addBlock(int left, int top) {
        double blockSquares = 0;
        int blockPixels = 0;
        for (int y = top; y < Math.min(top + BLOCK, test.height()); y++) {
            for (int x = left; x < Math.min(left + BLOCK, test.width()); x++) {
                int offset = test.offset(x, y);
                if (mask.includes(x, y) && isFinite(test.samples(), offset) && isFinite(reference.samples(), offset)) {
                    blockSquares += addPixel(offset);
                    blockPixels++;
                }
            }
        }
        if (blockPixels > 0) {
            worstBlock = Math.max(worstBlock, Math.sqrt(blockSquares / (3 * blockPixels)));
        }
    }

    /** Returns the sum of the squared differences of the channels. */
    private double addPixel(int offset) {
        double pixelSquares = 0;
        double relativeTerm = 0;
        for (int i = offset; i < offset + 3; i++) {
            double expected = reference.samples()[i];
            double difference = test.samples()[i] - expected;
            double square = difference * difference;
            pixelSquares += square;
            relativeTerm += quotient(square, expected * expected + offsetSquared);
            absolutes.add(Math.abs(difference));
            differences.add(difference);
            largest = Math.max(largest, Math.abs(difference));
        }
        squares.add(pixelSquares);
        relativeTerms[termCount++] = relativeTerm / 3;
        return pixelSquares;
    }

    private double mean(int terms) {
        CompensatedSum sum = new CompensatedSum();
        for (int i = 0; i < terms; i++) {
            sum.add(relativeTerms[i]);
        }
        return sum.value() / terms;
    }

    /** No error is no error, relative to nothing as well. */
    private static double quotient(double error, double scale) {
        return error == 0 ? 0 : error / scale;
    }

    private static boolean isFinite(float[] samples, int offset) {
        return Float.isFinite(samples[offset])
                && Float.isFinite(samples[offset + 1])
                && Float.isFinite(samples[offset + 2]);
    }
}
