package org.diacaustic.page;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.diacaustic.image.LinearImage;
import org.diacaustic.study.Budget;
import org.diacaustic.study.ColdTimes;
import org.diacaustic.study.Machine;
import org.diacaustic.study.Measure;
import org.diacaustic.study.Reference;
import org.diacaustic.study.ShadingStudy;
import org.diacaustic.study.StudyPictures;
import org.diacaustic.study.StudyPoint;
import org.diacaustic.study.StudyReport;
import org.diacaustic.study.StudyRun;
import org.diacaustic.study.Technique;
import org.diacaustic.study.TechniqueStudy;
import org.diacaustic.study.Techniques;

/**
 * A report that nothing was rendered for. Errors are powers of the light rays, √(chance² + bias²), a light ray takes a
 * microsecond, and runs differ by a few per cent that depend on the seed only. The reference is 1 where pixels count.
 */
final class FakeStudy {
    private static final int RUNS = 5;
    private static final double[] SPREAD = {-0.06, 0.04, 0, 0.07, -0.05};

    private final int side;
    private final double referenceError;
    private final List<TechniqueStudy> studies = new ArrayList<>();
    private final Map<Technique, Double> brightness = new java.util.HashMap<>();
    private int planned;

    /**
     * @param side of pictures, in pixels
     * @param referenceError of the reference, as a part of the mean
     */
    FakeStudy(int side, double referenceError) {
        this.side = side;
        this.referenceError = referenceError;
    }

    /**
     * Adds a technique.
     *
     * @param power of its chance, which is 1 with one light ray
     * @param bias whatever the light rays; it is too bright by as much
     */
    FakeStudy add(Technique technique, double power, double bias, long... rays) {
        List<StudyPoint> points = new ArrayList<>();
        for (long count : rays) {
            points.add(point(count, Math.pow(count, power), bias));
        }
        planned += rays.length;
        brightness.put(technique, bias);
        studies.add(new TechniqueStudy(technique, points, ""));
        return this;
    }

    FakeStudy refuse(Technique technique, String reason) {
        studies.add(new TechniqueStudy(technique, List.of(), reason));
        return this;
    }

    /** Points that are still to come. */
    FakeStudy missing(int points) {
        planned += points;
        return this;
    }

    static Technique known(String name) {
        return Techniques.parse(name).get(0);
    }

    private StudyPoint point(long rays, double chance, double bias) {
        List<StudyRun> runs = new ArrayList<>();
        for (int seed = 0; seed < RUNS; seed++) {
            runs.add(run(seed + 1, rays, Math.hypot(chance, bias) * (1 + SPREAD[seed]), bias + chance * SPREAD[seed]));
        }
        return new StudyPoint(
                new Budget.Rays(rays), rays, 1, bias * bias - 1e-9, chance * chance, referenceError, runs);
    }

    private static StudyRun run(long seed, long rays, double error, double bias) {
        Map<Measure, Double> values = new EnumMap<>(Measure.class);
        for (Measure measure : Measure.values()) {
            values.put(measure, (double) rays);
        }
        for (Measure measure : List.of(Measure.RMS_ERROR, Measure.MEASURED_RMS_ERROR, Measure.ABSOLUTE_ERROR)) {
            values.put(measure, error);
        }
        values.put(Measure.RELATIVE_SQUARE_ERROR, error * error);
        values.put(Measure.TRIMMED_SQUARE_ERROR, 0.9 * error * error);
        values.put(Measure.WORST_BLOCK, 4 * error);
        values.put(Measure.BRIGHTNESS, bias);
        double seconds = 1e-6 * rays * (1 + 0.01 * seed);
        values.put(Measure.PROCESSOR_SECONDS, 2 * seconds);
        values.put(Measure.WALL_SECONDS, 1.2 * seconds);
        values.put(Measure.FORWARD_SECONDS, 0.5 * seconds);
        values.put(Measure.BUILD_SECONDS, 0.2 * seconds);
        values.put(Measure.GATHER_SECONDS, 0.3 * seconds);
        values.put(Measure.EYE_SECONDS, 0.1 * seconds);
        return new StudyRun(seed, values);
    }

    StudyReport report() {
        LinearImage counted = new LinearImage(side, side);
        LinearImage picture = new LinearImage(side, side);
        LinearImage error = new LinearImage(side, side);
        for (int y = 0; y < side; y++) {
            for (int x = 0; x < side; x++) {
                boolean counts = x > 0;
                double value = counts ? 1 : 0.2;
                picture.set(x, y, value, value, value);
                error.set(x, y, referenceError, referenceError, referenceError);
                if (counts) {
                    counted.set(x, y, 1, 1, 1);
                }
            }
        }
        Reference reference = new Reference(
                Reference.Origin.LIGHT_TRACED, picture, Optional.of(error), Optional.of(error), 1_000_000, 16, 3.5);
        return new StudyReport(
                "fake <scene>",
                "diacaustic study fake.yaml -o out",
                new Machine("Linux amd64", "a <processor>", 2, "some Java", "1.0"),
                2,
                1,
                reference,
                counted,
                0.1,
                studies,
                List.of(new ShadingStudy("non-transparent", run(1, 1, 0.8, -0.8))),
                Optional.of(new ColdTimes(0.4, new Budget.Rays(10_000), Map.of("caustic-mesh", 1.1))),
                planned);
    }

    /** Pictures as bright as their techniques are wrong, darker in the first columns. */
    StudyPictures pictures() {
        return (technique, point) -> {
            LinearImage picture = new LinearImage(side, side);
            for (int i = 0; i < picture.samples().length; i++) {
                double ripple = point.error() * Math.sin(i * 12.9898);
                picture.samples()[i] = (float) (1 + brightness.get(technique) + ripple);
            }
            return Optional.of(picture);
        };
    }
}
