package org.diacaustic.study;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.diacaustic.image.LinearImage;
import org.diacaustic.parallel.Workers;
import org.diacaustic.render.RenderJob;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneDocument;
import org.diacaustic.scenefile.SceneFile;
import org.diacaustic.scenefile.SceneReader;

/**
 * Light that is smooth wherever it is seen: a lamp at height 1.6 shines through a sheet that does not bend, onto a floor. Light ends
 * 1.28 from the middle; seen are no more than 0.42 to each side. What straight shadow rays bring is exact.
 */
final class SmoothLight {
    private static final double HEIGHT = 1.6;
    private static final int SIDE = 8;
    private static final double SEEN = Math.tan(Math.toRadians(22.5));
    private static final int THREADS = 2;

    private static final String SCENE = """
            camera: {from: [0, 1, 0], to: [0, 0, 0], up: [0, 0, 1], size: [8, 8], field-of-view: 45}
            lights:
              - point: {at: [0, 1.6, 0], intensity: 10}
            materials:
              grey: {diffuse: 0.5}
              clear: {transparency: 0.9, ior: 1}
            objects:
              - polygon: {name: floor, vertices: [[-2, 0, 2], [2, 0, 2], [2, 0, -2], [-2, 0, -2]], material: grey}
              - polygon:
                  name: sheet
                  vertices: [[-0.24, 1.3, 0.24], [0.24, 1.3, 0.24], [0.24, 1.3, -0.24], [-0.24, 1.3, -0.24]]
                  material: clear
            settings: {samples: 4}
            """;

    private final LinearImage exact =
            render(plan(Map.of("shader", "non-refractive", "clamp", "false", "samples", "2500")));

    /**
     * What many pictures of one thing tell.
     *
     * @param meanSquare of their errors ÷ squared mean of the exact picture, as all three
     * @param variance of a single one
     * @param squaredBias without the chance of the mean
     * @param brightness mean error of each picture ÷ mean of the exact one
     */
    record Errors(double meanSquare, double variance, double squaredBias, double[] brightness) {

        double meanBrightness() {
            return Distribution.mean(brightness);
        }

        /** Of the mean brightness. */
        double standardError() {
            double mean = meanBrightness();
            double squares = 0;
            for (double each : brightness) {
                squares += (each - mean) * (each - mean);
            }
            return Math.sqrt(squares / (brightness.length - 1) / brightness.length);
        }
    }

    private static RenderPlan plan(Map<String, String> overrides) {
        Problems problems = new Problems();
        SceneDocument document = SceneDocument.parse("smooth.yaml", SCENE, problems);
        overrides.forEach((key, value) -> document.override("settings", key, value));
        SceneFile file = SceneReader.read(document, problems).orElseThrow(() -> new AssertionError(problems));
        return RenderPlan.of(file.scene(), file.settings());
    }

    private static LinearImage render(RenderPlan plan) {
        return new RenderJob(plan, THREADS, (done, total) -> {}).run().image();
    }

    /** Renders with seeds from 1 on; settings are pairs such as {@code rays=1000}. */
    Errors errors(Technique technique, int seeds, String... settings) {
        return errors(IntStream.rangeClosed(1, seeds)
                .mapToObj(seed -> render(plan(overrides(technique, seed, settings))))
                .toList());
    }

    /** Light traced from the lamp into the pixels, by random rays. */
    LinearImage traced(long rays, int seed) {
        Technique technique = new Technique("any", Technique.Way.OVER_A_MAP, Map.of("preprocessor", "random"), 0);
        RenderPlan plan = plan(overrides(technique, seed, "map=photon-map", "rays=" + rays));
        LightTracedPicture picture = new LightTracedPicture(plan, new Workers(THREADS), 1, strip -> {});
        picture.add(0);
        return picture.picture();
    }

    private static Map<String, String> overrides(Technique technique, int seed, String... settings) {
        Map<String, String> overrides = new LinkedHashMap<>(technique.overrides());
        overrides.put("seed", Integer.toString(seed));
        for (String setting : settings) {
            String[] pair = setting.split("=");
            overrides.put(pair[0], pair[1]);
        }
        return overrides;
    }

    Errors errors(List<LinearImage> pictures) {
        int count = pictures.size();
        int pixels = SIDE * SIDE;
        double[] brightness = new double[count];
        double mean = 0;
        double meanSquare = 0;
        double variance = 0;
        double squaredBias = 0;
        for (int pixel = 0; pixel < pixels; pixel++) {
            double truth = exact.samples()[3 * pixel];
            mean += truth / pixels;
            double sum = 0;
            double squares = 0;
            for (int i = 0; i < count; i++) {
                double off = pictures.get(i).samples()[3 * pixel] - truth;
                brightness[i] += off / pixels;
                sum += off;
                squares += off * off;
            }
            double spread = (squares - sum * sum / count) / (count - 1);
            meanSquare += squares / count / pixels;
            variance += spread / pixels;
            squaredBias += (sum * sum / count - spread) / count / pixels;
        }
        for (int i = 0; i < count; i++) {
            brightness[i] /= mean;
        }
        double scale = 1 / (mean * mean);
        return new Errors(meanSquare * scale, variance * scale, squaredBias * scale, brightness);
    }

    /**
     * The squared bias of Epanechnikov's kernel, by quadrature: irradiance (h² + ρ²)^(−3/2), smoothed, less irradiance, at the
     * middles of the pixels.
     */
    static double squaredBiasOfKernel(double radius) {
        double squares = 0;
        double mean = 0;
        for (int pixel = 0; pixel < SIDE * SIDE; pixel++) {
            double x = SEEN * (2 * (pixel % SIDE + 0.5) / SIDE - 1);
            double z = SEEN * (2 * (pixel / SIDE + 0.5) / SIDE - 1);
            double off = smoothed(x, z, radius) - irradiance(x, z);
            squares += off * off / (SIDE * SIDE);
            mean += irradiance(x, z) / (SIDE * SIDE);
        }
        return squares / (mean * mean);
    }

    private static double smoothed(double x, double z, double radius) {
        int rings = 100;
        int spokes = 32;
        double sum = 0;
        double weights = 0;
        for (int ring = 0; ring < rings; ring++) {
            double part = (ring + 0.5) / rings;
            double weight = part * (1 - part * part);
            for (int spoke = 0; spoke < spokes; spoke++) {
                double angle = 2 * Math.PI * spoke / spokes;
                double reach = part * radius;
                sum += weight * irradiance(x + reach * Math.cos(angle), z + reach * Math.sin(angle));
                weights += weight;
            }
        }
        return sum / weights;
    }

    private static double irradiance(double x, double z) {
        return Math.pow(HEIGHT * HEIGHT + x * x + z * z, -1.5);
    }
}
