package org.diacaustic.study;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.LinearImage;

/**
 * What a study found.
 *
 * @param scene name of the scene
 * @param command how to run it again
 * @param counted white where pixels counted, black elsewhere
 * @param gatherRadius that all techniques have which look for photons within a fixed reach, in scene units; 0 if none does
 * @param shading the shading models, alone
 * @param cold whole processes; nothing if none was started
 * @param pointsPlanned points that the whole study has; those of refused techniques are not among them
 */
public record StudyReport(
        String scene,
        String command,
        Machine machine,
        int threads,
        long seed,
        Reference reference,
        LinearImage counted,
        double gatherRadius,
        List<TechniqueStudy> studies,
        List<ShadingStudy> shading,
        Optional<ColdTimes> cold,
        int pointsPlanned) {

    public StudyReport {
        studies = List.copyOf(studies);
        shading = List.copyOf(shading);
    }

    /** How many points are there. */
    public int points() {
        return studies.stream().mapToInt(study -> study.points().size()).sum();
    }

    /** Whether the study came to its end. */
    public boolean isComplete() {
        return points() >= pointsPlanned;
    }

    /** The mean of the reference over the pixels that count. */
    public double referenceMean() {
        return meanOverCounted(reference.picture(), value -> value);
    }

    /** The root mean square of a difference of pictures over the pixels that count ÷ mean of the reference over them. */
    public double rootMeanSquare(LinearImage difference) {
        return Math.sqrt(meanOverCounted(difference, value -> value * value)) / referenceMean();
    }

    private double meanOverCounted(LinearImage picture, DoubleUnaryOperator of) {
        double sum = 0;
        long samples = 0;
        for (int i = 0; i < picture.samples().length; i++) {
            if (counted.samples()[i] > 0) {
                sum += of.applyAsDouble(picture.samples()[i]);
                samples++;
            }
        }
        return sum / samples;
    }

    /** The same with the times of whole processes. */
    public StudyReport with(ColdTimes times) {
        return new StudyReport(
                scene,
                command,
                machine,
                threads,
                seed,
                reference,
                counted,
                gatherRadius,
                studies,
                shading,
                Optional.of(times),
                pointsPlanned);
    }

    /** The numbers as text in columns, one line a point. */
    public String table() {
        return new StudyTable(this).text();
    }

    /**
     * Writes the numbers into the folder of the study: {@code study.json}, {@code runs.csv}, {@code points.csv}, and which pixels
     * counted.
     *
     * @throws IOException if that fails
     */
    public void write(StudyFolder folder) throws IOException {
        StudyCsv csv = new StudyCsv(this);
        folder.write("runs.csv", csv.runs());
        folder.write("points.csv", csv.points());
        folder.write("study.json", new StudyJson(this).text());
        ImageFiles.write(counted, Exposure.fixed(1), folder.path().resolve("counted.png"));
    }
}
