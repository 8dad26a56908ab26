package org.diacaustic.trial;

import java.util.SplittableRandom;
import org.diacaustic.image.LinearImage;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.material.Wave;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.render.RadianceProbe;
import org.diacaustic.render.RenderJob;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shader.NonRefractiveShader;
import org.diacaustic.shape.Sphere;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Scenes whose pictures are known without any optics: what does not bend light, and what cannot be seen. */
final class ControlTrials {
    private static final int PIXELS = 256;
    private static final int BLOCK = 8;
    private static final int BLOCKS = PIXELS / BLOCK;
    private static final long LIGHT_RAYS = 100_000;
    private static final int DIRECTIONS = 10_000;

    /** The floor that is looked at goes this far from the middle; lamp and sheet are at these heights. */
    private static final double HALF = 2;

    private static final double LAMP = 12;
    private static final double SHEET = 4;

    /** Far below the side of a block, 1/8, and what the lamp's light changes in. */
    private static final double GATHER_RADIUS = 0.02;

    private ControlTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "control_equivalence",
                "Photons of 16 runs through a bumped sheet with the same index on both sides, looked up at 256 × 256 points of the"
                        + " floor, against the radiance that the eye pass finds there with the non-refractive shader; the kernel is"
                        + " so small that convolution changes it by less than 1e-5. z of a block of 8 × 8 is its mean ÷ standard"
                        + " error, times what makes the variance of Student's t of 15 degrees of freedom 1. And 10,000 rays through"
                        + " the sheet by the light walk, bit by bit.",
                ControlTrials::equivalence);
        operations.add(
                "glass_furnace",
                "A picture of a ball under a uniform background: its worst pixel. The eye's sample in the middle with max-depth ="
                        + " max_internal_events + 1, so that so many meetings with the wall from within go on; what is missing of it,"
                        + " and what the light walk books as cut with the same depth.",
                ControlTrials::furnace);
    }

    private static void equivalence(NumericCase asked, Checks checks) {
        Scene scene = control(asked);
        double[] model = model(scene);
        double[][] runs = new double[Estimate.RUNS][];
        for (int run = 0; run < runs.length; run++) {
            Settings settings = OpticalScenes.gathering(
                    OpticalScenes.settings(4, true, true), GATHER_RADIUS, Estimate.FIRST_SEED + run);
            runs[run] =
                    gathered(LightRun.of(scene, settings, "random", LIGHT_RAYS).lookup());
        }
        double sum = 0;
        double squares = 0;
        int over5 = 0;
        // The variance of Student's t of ν degrees of freedom is ν ÷ (ν − 2).
        double spread = Math.sqrt((runs.length - 3.0) / (runs.length - 1));
        for (int block = 0; block < model.length; block++) {
            double[] found = new double[runs.length];
            for (int run = 0; run < runs.length; run++) {
                found[run] = runs[run][block];
            }
            double z = spread * Estimate.of(found).score(model[block]);
            sum += z;
            squares += z * z;
            over5 += Math.abs(z) > 5 ? 1 : 0;
        }
        double mean = sum / model.length;
        checks.number("mean of z", 0, mean, 4 / Math.sqrt(model.length));
        checks.number("variance of z", 1, squares / model.length - mean * mean, 0.2);
        checks.atMost("blocks_over_5_sigma", asked.tolerance().number("blocks_over_5_sigma", 0), over5);
        checks.same("rays that were turned", 0, turned(scene));
    }

    /** A sheet that bends nothing between a lamp and a floor; the eye is under it, and sees the floor's grid as its pixels. */
    private static Scene control(NumericCase asked) {
        double waveNumber = 3;
        Medium medium = Medium.of(asked.inputs().number("n"));
        Material sheet = Material.builder()
                .transparency(Color.grey(asked.inputs().number("transparency")))
                .inside(medium)
                .outside(medium)
                .bump(new Wave(
                        new Vector3(0.8, 0, 0.6), waveNumber, asked.inputs().number("max_slope") / waveNumber, 0.4))
                .build();
        Camera camera = Camera.builder()
                .from(new Vector3(0, HALF, 0))
                .to(Vector3.ZERO)
                .up(Vector3.UNIT_Z.negated())
                .fieldOfView(90)
                .size(PIXELS, PIXELS)
                .build();
        return OpticalScenes.overFloor(
                camera, OpticalScenes.lamp(LAMP, 1), 0, OpticalScenes.square(SHEET, HALF), sheet);
    }

    /** The mean irradiance of each block that straight shadow rays find. */
    private static double[] model(Scene scene) {
        Settings settings = OpticalScenes.direct(Settings.physical()).toBuilder()
                .shader(NonRefractiveShader.NAME)
                .build();
        RadianceProbe probe = new RadianceProbe(RenderPlan.of(scene, settings));
        return blocks((x, y) -> Math.PI * probe.through(x + 0.5, y + 0.5).green());
    }

    private static double[] gathered(IlluminationMap.Lookup lookup) {
        double step = 2 * HALF / PIXELS;
        return blocks((x, y) -> LightRun.irradiance(lookup, 0, (x + 0.5) * step - HALF, 0, (y + 0.5) * step - HALF));
    }

    private static double[] blocks(Pixels pixels) {
        double[] means = new double[BLOCKS * BLOCKS];
        for (int y = 0; y < PIXELS; y++) {
            for (int x = 0; x < PIXELS; x++) {
                means[y / BLOCK * BLOCKS + x / BLOCK] += pixels.at(x, y) / (BLOCK * BLOCK);
            }
        }
        return means;
    }

    /** How many of rays in all directions leave the sheet in another direction, by any bit. */
    private static int turned(Scene scene) {
        RayWalk walk = RayWalk.in(scene, OpticalScenes.through(1, true));
        SplittableRandom random = new SplittableRandom(1);
        int turned = 0;
        for (int i = 0; i < DIRECTIONS; i++) {
            Vector3 from = new Vector3(random.nextDouble(-1, 1), SHEET + random.nextDouble(), random.nextDouble(-1, 1));
            Vector3 through = new Vector3(random.nextDouble(-HALF, HALF), SHEET, random.nextDouble(-HALF, HALF));
            Vector3 towards = through.minus(from);
            turned += walk.follow(from, towards).direction().equals(towards.normalized()) ? 0 : 1;
        }
        return turned;
    }

    private static void furnace(NumericCase asked, Checks checks) {
        double n = asked.inputs().number("n");
        long events = asked.inputs().integer("max_internal_events");
        if (events < 0 || events >= Integer.MAX_VALUE) {
            throw new CaseFault("max_internal_events should be a depth, but is " + events);
        }
        Scene scene = Scene.builder()
                .camera(Camera.builder()
                        .from(new Vector3(0, 0, 4))
                        .to(Vector3.ZERO)
                        .size(32, 32)
                        .build())
                .background(Color.WHITE)
                .object("ball", new Sphere(Vector3.ZERO, 1), OpticalScenes.clear(n))
                .build();
        Settings all = OpticalScenes.settings(100_000, true, true).toBuilder()
                .minimumThroughput(0x1p-30)
                .build();
        LinearImage picture = new RenderJob(RenderPlan.of(scene, all), 1, (done, total) -> {})
                .run()
                .image();
        checks.number(
                "pixel",
                asked.expected().decimal("pixel").doubleValue(),
                worst(picture),
                asked.tolerance().number("abs_full"));
        Settings truncated = OpticalScenes.settings((int) events + 1, true, true);
        double middle = new RadianceProbe(RenderPlan.of(scene, truncated))
                .through(16, 16)
                .green();
        double missing = asked.expected().number("missing");
        double cut = RayWalk.in(scene, truncated)
                .follow(new Vector3(0, 0, 4), Vector3.UNIT_Z.negated())
                .cut();
        checks.number("centre_pixel_truncated", middle, "");
        checks.number("missing", missing, 1 - middle, 8 * Math.ulp(1.0));
        checks.number("missing, as cut", missing, cut, 1e-12 * missing);
    }

    /** The pixel that is farthest from 1. */
    private static double worst(LinearImage picture) {
        double worst = 1;
        for (float sample : picture.samples()) {
            worst = Math.abs(sample - 1) > Math.abs(worst - 1) || Float.isNaN(sample) ? sample : worst;
        }
        return worst;
    }

    private interface Pixels {
        double at(int x, int y);
    }
}
