package org.diacaustic.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import org.diacaustic.image.DifferenceImage;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.ImageMetrics;
import org.diacaustic.image.LinearImage;
import org.diacaustic.json.JsonWriter;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code compare}: how far one picture lies from another. */
@Command(
        name = "compare",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = "Prints error metrics of a picture against a reference, in linear light.")
final class CompareCommand implements Callable<Integer> {
    @Parameters(index = "0", paramLabel = "A", description = "The picture.")
    private Path test;

    @Parameters(index = "1", paramLabel = "B", description = "The reference.")
    private Path reference;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "DIFF.png",
            description = "Write a picture of the difference.")
    private Path output;

    @Option(names = "--json", description = "As JSON.")
    private boolean json;

    @Option(names = "--debug", description = "Show a stack trace when something fails.")
    private boolean debug;

    @Override
    public Integer call() throws IOException {
        if (output != null) {
            ImageFiles.checkWritable(output);
        }
        LinearImage first = ImageFiles.read(test);
        LinearImage second = ImageFiles.read(reference);
        ImageMetrics metrics = ImageMetrics.of(first, second);
        print(metrics);
        if (output != null) {
            DifferenceImage difference = DifferenceImage.of(first, second);
            ImageFiles.write(difference.picture(), Exposure.fixed(1), output);
            if (!json) {
                System.out.printf(
                        Locale.ROOT,
                        "%s: red is brighter, blue darker; full colour at %.4g%n",
                        output,
                        difference.scale());
            }
        }
        return ExitCode.DONE;
    }

    private void print(ImageMetrics metrics) {
        Map<String, Double> values = new LinkedHashMap<>();
        values.put("rRMSE", metrics.relativeRootMeanSquareError());
        values.put("relMAE", metrics.relativeMeanAbsoluteError());
        values.put("relMSE", metrics.relativeMeanSquareError());
        values.put("relMSE99.9", metrics.trimmedRelativeMeanSquareError());
        values.put("worstBlock", metrics.worstBlockError());
        values.put("largest", metrics.largestAbsoluteError());
        values.put("bias", metrics.bias());
        values.put("referenceMean", metrics.referenceMean());
        Map<String, Long> counts = new LinkedHashMap<>();
        counts.put("pixels", metrics.comparedPixels());
        counts.put("nonFiniteA", metrics.nonFiniteTestPixels());
        counts.put("nonFiniteB", metrics.nonFiniteReferencePixels());
        if (json) {
            JsonWriter writer = new JsonWriter();
            writer.beginObject();
            values.forEach(writer::put);
            counts.forEach(writer::put);
            writer.end();
            System.out.print(writer);
        } else {
            values.forEach((name, value) -> System.out.printf(Locale.ROOT, "%-14s %.6g%n", name, value));
            counts.forEach((name, value) -> System.out.printf(Locale.ROOT, "%-14s %d%n", name, value));
        }
    }
}
