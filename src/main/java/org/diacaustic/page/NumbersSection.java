package org.diacaustic.page;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.diacaustic.study.Measure;
import org.diacaustic.study.StudyPoint;
import org.diacaustic.study.TechniqueStudy;

/** Every number, a table a technique. */
final class NumbersSection {
    private static final List<Measure> ERRORS = List.of(
            Measure.RMS_ERROR,
            Measure.MEASURED_RMS_ERROR,
            Measure.ABSOLUTE_ERROR,
            Measure.RELATIVE_SQUARE_ERROR,
            Measure.TRIMMED_SQUARE_ERROR,
            Measure.WORST_BLOCK);

    private static final List<Measure> COUNTS = List.of(
            Measure.LIGHT_RAYS, Measure.INTERSECTION_TESTS, Measure.NODES_EXAMINED, Measure.WORK, Measure.STORED);

    private static final List<Measure> TIMES = List.of(
            Measure.PROCESSOR_SECONDS,
            Measure.WALL_SECONDS,
            Measure.FORWARD_SECONDS,
            Measure.BUILD_SECONDS,
            Measure.GATHER_SECONDS,
            Measure.EYE_SECONDS);

    private final StudyNumbers numbers;

    NumbersSection(StudyNumbers numbers) {
        this.numbers = numbers;
    }

    void write(PageWriter page) {
        page.section("numbers", "Every number");
        page.paragraph(
                "Means over runs, errors relative to the mean of the reference. The same are in the files beside this page.");
        numbers.started().forEach(study -> table(page, study));
        page.endSection();
    }

    private void table(PageWriter page, TechniqueStudy study) {
        page.format("<details><summary>%s</summary>", study.technique().name());
        List<String> settings = new ArrayList<>();
        study.technique().overrides().forEach((key, value) -> settings.add(key + ": " + value));
        page.remark("Laid over the settings of the scene: " + String.join(", ", settings) + ".");
        List<String> heads = new ArrayList<>(List.of("budget"));
        study.points().forEach(point -> heads.add(Numbers.budget(point.budget())));
        page.table("numbers", heads);
        row(page, study, "light rays chosen", point -> Numbers.count(point.rays()));
        row(page, study, "passes", point -> Integer.toString(point.passes()));
        row(page, study, "runs", point -> Integer.toString(point.runs().size()));
        for (Measure measure : ERRORS) {
            row(
                    page,
                    study,
                    measure.title() + " (" + measure.key() + ")",
                    point -> words(measure, point.mean(measure)));
            if (measure == Measure.RMS_ERROR) {
                row(
                        page,
                        study,
                        "… its mean with a chance of 95 %",
                        point -> Numbers.interval(
                                numbers.distribution(point, measure).meanInterval(), Numbers::percent));
                row(
                        page,
                        study,
                        "… of single runs",
                        point -> Numbers.interval(
                                numbers.distribution(point, measure).band(), Numbers::percent));
            }
        }
        row(
                page,
                study,
                "mean difference, of the light over specular surfaces",
                point -> Numbers.signedPercent(point.mean(Measure.BRIGHTNESS)));
        row(page, study, "root of squared bias", point -> root(point.squaredBias()));
        row(page, study, "root of variance", point -> root(point.variance()));
        row(page, study, "the reference’s own error", point -> Numbers.percent(point.referenceError()));
        TIMES.forEach(measure -> row(page, study, measure.title(), point -> Numbers.seconds(point.mean(measure))));
        COUNTS.forEach(measure -> row(page, study, measure.title(), point -> Numbers.count(point.mean(measure))));
        row(page, study, Measure.MAP_BYTES.title(), point -> Numbers.bytes(point.mean(Measure.MAP_BYTES)));
        page.endTable().add("</details>");
    }

    /** Errors are parts of the mean, but for those that are squares. */
    private static String words(Measure measure, double error) {
        boolean isSquare = measure == Measure.RELATIVE_SQUARE_ERROR || measure == Measure.TRIMMED_SQUARE_ERROR;
        return isSquare ? Numbers.digits(error) : Numbers.percent(error);
    }

    /** Of a square that chance may have made negative: then nothing is known but that it is small. */
    private static String root(double square) {
        return square <= 0 ? "not above chance" : Numbers.percent(Math.sqrt(square));
    }

    private static void row(PageWriter page, TechniqueStudy study, String head, Function<StudyPoint, String> words) {
        List<String> cells = new ArrayList<>(List.of(head));
        study.points().forEach(point -> cells.add(words.apply(point)));
        page.row(cells);
    }
}
