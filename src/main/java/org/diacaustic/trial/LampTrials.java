package org.diacaustic.trial;

import org.diacaustic.light.Falloff;
import org.diacaustic.light.FlatLight;
import org.diacaustic.light.Light;
import org.diacaustic.light.LightPoint;
import org.diacaustic.light.LightSample;
import org.diacaustic.light.SpotLight;
import org.diacaustic.math.Color;
import org.diacaustic.math.CompensatedSum;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.preprocess.EnergyLedger;
import org.diacaustic.render.RadianceProbe;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Sphere;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Lights that do not shine alike everywhere. */
final class LampTrials {
    private static final double EMISSION_ROUNDING = 1e-11;
    private static final double FLUX_ROUNDING = 4 * Math.ulp(1.0);
    private static final long RAYS = 20_000;

    /** Too few light rays of a narrower spot count to tell its flux. */
    private static final double WIDE_ENOUGH = 0.01;

    private static final int PANELS = 160;
    private static final double NARROWER = 0.7;
    private static final int PIXELS = 256;
    private static final int SAMPLES = 16;

    /** Nodes in −1..1 and weights of Gauss' rule for polynomials up to degree 15, the positive half. */
    private static final double[] NODES = {
        0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363
    };

    private static final double[] WEIGHTS = {
        0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763
    };

    private LampTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "spot_flux",
                "The flux that the spot states. It must also be 4π·sin² of half the angle at which its emission ends, found by bisection;"
                        + " and, for spots wider than that 1 ray in 100 counts, what the ledger of 20,000 random light rays has been"
                        + " sent, within 4 sigma.",
                LampTrials::spot);
        operations.add(
                "disc_light",
                "The samples of the disc light as direct light takes them, integrated over the disc by Gauss' rule of 8 points on panels"
                        + " that get narrower towards its middle; then as 256 eye rays see it, 16 samples each, within 4 sigma of what"
                        + " such integrals tell of the samples' scatter.",
                LampTrials::disc);
    }

    private static void spot(NumericCase asked, Checks checks) {
        double degrees = asked.inputs().number("half_angle_deg");
        double intensity = asked.inputs().number("intensity");
        SpotLight spot = new SpotLight(
                Vector3.ZERO, Vector3.UNIT_Z, degrees, degrees, Color.grey(intensity), new Falloff.InverseSquare(), 0);
        double flux = spot.flux().green();
        checks.number("flux", flux);
        double sine = StrictMath.sin(0.5 * edge(spot));
        checks.number(
                "flux within the edge of the emission",
                flux,
                4 * Math.PI * sine * sine * intensity,
                EMISSION_ROUNDING * flux);
        double share = flux / (4 * Math.PI * intensity);
        if (share > WIDE_ENOUGH) {
            double error = Math.sqrt(share * (1 - share) / RAYS) * 4 * Math.PI * intensity;
            double got = ledger(spot).emitted() / 3;
            checks.statistic("flux of light rays", flux, got, error + FLUX_ROUNDING * flux, 4);
        }
    }

    /** The angle from the axis at which the light ends. */
    private static double edge(Light light) {
        double low = 0;
        double high = Math.PI;
        if (intensity(light, high) > 0) {
            return high;
        }
        for (double middle = 0.5 * high; middle > low && middle < high; middle = low + 0.5 * (high - low)) {
            boolean isLit = intensity(light, middle) > 0;
            low = isLit ? middle : low;
            high = isLit ? high : middle;
        }
        return low;
    }

    private static double intensity(Light light, double angle) {
        Rgb out = new Rgb();
        light.emit(new LightPoint(), StrictMath.sin(angle), 0, StrictMath.cos(angle), out);
        return out.green;
    }

    /** Of rays into all directions, out of a ball that does nothing to them. */
    private static EnergyLedger ledger(Light light) {
        Scene scene = Scene.builder()
                .camera(Stage.eye(Vector3.ZERO, Vector3.UNIT_X))
                .light(light)
                .object("ball", new Sphere(Vector3.ZERO, 1), Stage.clear(1))
                .object("floor", new Plane(new Vector3(0, -4, 0), Vector3.UNIT_Y), Stage.WHITE)
                .build();
        return LightRun.of(scene, Settings.physical(), "random", RAYS).ledger();
    }

    private static void disc(NumericCase asked, Checks checks) {
        double radius = asked.inputs().number("radius");
        double height = asked.inputs().number("height");
        double exitance = asked.inputs().number("exitance");
        Vector3 down = new Vector3(0, -1, 0);
        FlatLight lamp = FlatLight.disc(
                new Vector3(0, height, 0),
                down,
                radius,
                Color.grey(exitance / Math.PI),
                new Falloff.InverseSquare(),
                SAMPLES);
        checks.number("E", integrated(lamp, 0, 1, 1));
        double expected = asked.expected().number("E");
        double error = standardError(lamp) / Math.sqrt(PIXELS);
        checks.statistic("E of eye rays", expected, seen(lamp, height, down), error + FLUX_ROUNDING * expected, 4);
    }

    /** The standard error of the irradiance from one pixel's samples, each somewhere within a part of the disc of its own. */
    private static double standardError(Light lamp) {
        double variance = 0;
        for (int i = 0; i < SAMPLES; i++) {
            double low = (double) i / SAMPLES;
            double mean = SAMPLES * integrated(lamp, low, low + 1.0 / SAMPLES, 1);
            double square = SAMPLES * integrated(lamp, low, low + 1.0 / SAMPLES, 2);
            variance += Math.max(0, square - mean * mean) / SAMPLES;
        }
        return Math.sqrt(variance / SAMPLES);
    }

    /**
     * The integral over a part of the disc of a power of the irradiance of an upward surface at the origin: what samples carry
     * depends on their distance from the middle only.
     */
    private static double integrated(Light lamp, double from, double to, int power) {
        CompensatedSum sum = new CompensatedSum();
        double high = to;
        for (int panel = 0; high > from; panel++) {
            double low = panel == PANELS - 1 ? from : Math.max(from, NARROWER * high);
            sum.add(panel(lamp, low, high, power));
            high = low;
        }
        return sum.value();
    }

    private static double panel(Light lamp, double low, double high, int power) {
        LightSample sample = new LightSample();
        double sum = 0;
        for (int i = 0; i < 2 * NODES.length; i++) {
            double node = i < NODES.length ? NODES[i] : -NODES[i - NODES.length];
            double s = 0.5 * (low + high) + 0.5 * (high - low) * node;
            if (lamp.sample(0, 0, 0, s, 0.125, sample)) {
                double irradiance = sample.directionY * sample.irradiance.green;
                sum += WEIGHTS[i % NODES.length] * (power == 1 ? irradiance : irradiance * irradiance);
            }
        }
        return 0.5 * (high - low) * sum;
    }

    /** The mean of the pixels there, as seen along the floor's normal from below the lamp. */
    private static double seen(Light lamp, double height, Vector3 down) {
        Scene scene = Scene.builder()
                .camera(Stage.eye(new Vector3(0, 0.5 * height, 0), down))
                .light(lamp)
                .object("floor", new Plane(Vector3.ZERO, Vector3.UNIT_Y), Stage.WHITE)
                .build();
        RadianceProbe probe = Stage.probe(scene, Stage.plainLight());
        double sum = 0;
        for (int i = 0; i < PIXELS; i++) {
            sum += probe.along(down, i).green();
        }
        return sum / PIXELS;
    }
}
