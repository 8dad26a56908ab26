package org.diacaustic.trial;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.diacaustic.light.DirectionalLight;
import org.diacaustic.light.Light;
import org.diacaustic.light.PointLight;
import org.diacaustic.material.Material;
import org.diacaustic.math.Color;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.diacaustic.preprocess.EnergyLedger;
import org.diacaustic.render.RadianceProbe;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Disc;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Lights without extent, as the eye pass sees what they light. */
final class LightTrials {
    private static final Pattern PLANE = Pattern.compile("\\s*([xyz])\\s*=\\s*(\\S+)\\s*");
    private static final Vector3[] AXES = {Vector3.UNIT_X, Vector3.UNIT_Y, Vector3.UNIT_Z};
    private static final double[] ASIDE = {0x1p-40, 1e-3, 1, 1e6};
    private static final double SHADING_ROUNDING = 1e-12;
    private static final int PIXELS = 32;
    private static final long RAYS = 40_000;

    private LightTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "point_irradiance",
                "The radiance of a white floor without the 1/π, as an eye ray brings it, at a point at that distance and cosine from a"
                        + " lamp of that flux.",
                LightTrials::pointIrradiance);
        operations.add(
                "light_on_surface",
                "The same floor, with the lamp on it: nothing arrives at other points of either side, 1e-12 to 1e6 away, and what"
                        + " arrives where the lamp itself is is a finite number.",
                LightTrials::onSurface);
        operations.add(
                "light_at_camera",
                "1024 eye rays over a ball on a floor, with a lamp at the eye: radiance must be cos/r² of what is hit, within 1e-12, and"
                        + " nothing that faces the eye is dark.",
                LightTrials::atCamera);
        operations.add(
                "phong_power",
                "The highlight of a directional light on a mirror, as an eye ray brings it, without and with its normalisation; the"
                        + " thesis' convention is the former.",
                LightTrials::highlight);
        operations.add(
                "directional",
                "The floor of point_irradiance, turned to the light; and a half-transparent disc of the emission's radius across it,"
                        + " whose part of the ledger of 40,000 random light rays tells the flux, within 4 sigma.",
                LightTrials::directional);
    }

    /** The irradiance at the origin of a plane, as an eye one unit above it sees it. */
    private static double irradiance(Light light) {
        Vector3 down = new Vector3(0, -1, 0);
        Scene scene = Scene.builder()
                .camera(Stage.eye(Vector3.UNIT_Y, down))
                .light(light)
                .object("floor", new Plane(Vector3.ZERO, Vector3.UNIT_Y), Stage.WHITE)
                .build();
        return Stage.probe(scene, Stage.plainLight()).along(down, 0).green();
    }

    private static void pointIrradiance(NumericCase asked, Checks checks) {
        double flux = asked.inputs().number("flux");
        double distance = asked.inputs().number("distance");
        double cosine = asked.inputs().number("cos");
        double sine = Math.sqrt((1 - cosine) * (1 + cosine));
        PointLight lamp =
                new PointLight(new Vector3(distance * sine, distance * cosine, 0), Color.grey(flux / (4 * Math.PI)));
        checks.number("E", irradiance(lamp));
        checks.number("flux of the lamp", flux, lamp.flux().green(), 4 * Math.ulp(flux));
    }

    private static void onSurface(NumericCase asked, Checks checks) {
        Matcher plane = PLANE.matcher(asked.inputs().text("plane"));
        if (!plane.matches()) {
            throw new CaseFault("inputs.plane should be such as y=0, but is "
                    + asked.inputs().text("plane"));
        }
        int axis = "xyz".indexOf(plane.group(1));
        Vector3 normal = AXES[axis];
        Vector3 at = normal.times(Double.parseDouble(plane.group(2)));
        Vector3 lamp = Stage.vector(asked.inputs().vector("light"));
        Vector3 along = AXES[(axis + 1) % 3].plus(AXES[(axis + 2) % 3].times(0.5));
        double most = 0;
        for (Vector3 side : new Vector3[] {normal, normal.negated()}) {
            for (double aside : ASIDE) {
                Vector3 from = lamp.plus(along.times(aside)).plus(side);
                most = Math.max(most, Math.abs(seenOnPlane(at, normal, lamp, from, side.negated())));
            }
            double itself = seenOnPlane(at, normal, lamp, lamp.plus(side), side.negated());
            checks.holds("finite where the lamp is: " + itself, Double.isFinite(itself));
        }
        checks.same("largest E on the plane", 0.0, most);
    }

    private static double seenOnPlane(Vector3 at, Vector3 normal, Vector3 lamp, Vector3 from, Vector3 direction) {
        Scene scene = Scene.builder()
                .camera(Stage.eye(from, direction))
                .light(new PointLight(lamp, Color.WHITE))
                .object("plane", new Plane(at, normal), Stage.WHITE)
                .build();
        return Stage.probe(scene, Stage.plainLight()).along(direction, 0).green();
    }

    private static void atCamera(NumericCase asked, Checks checks) {
        Vector3 eye = Stage.vector(asked.inputs().vector("position"));
        double floor = eye.y() > 0 ? 0 : eye.y() - 1;
        double size = eye.y() - floor;
        Vector3 middle = new Vector3(eye.x(), floor + 0.4 * size, eye.z() - 4 * size);
        Camera camera = Camera.builder()
                .from(eye)
                .to(middle)
                .fieldOfView(60)
                .size(PIXELS, PIXELS)
                .build();
        Scene scene = Scene.builder()
                .camera(camera)
                .light(new PointLight(eye, Color.WHITE))
                .object("floor", new Plane(new Vector3(0, floor, 0), Vector3.UNIT_Y), Stage.WHITE)
                .object("ball", new Sphere(middle, 0.4 * size), Stage.WHITE)
                .build();
        RadianceProbe probe = Stage.probe(scene, Stage.plainLight());
        SceneIndex index = SceneIndex.of(scene.objects(), false);
        Ray ray = new Ray();
        long dark = 0;
        double worst = 0;
        for (int i = 0; i < PIXELS * PIXELS; i++) {
            int row = i / PIXELS;
            camera.aim(i % PIXELS + 0.5, row + 0.5, 0.5, 0.5, ray);
            Vector3 direction = new Vector3(ray.directionX, ray.directionY, ray.directionZ);
            double got = probe.along(direction, i).green();
            double expected = facing(index, ray);
            dark += expected > 0 && !(got > 0) ? 1 : 0;
            worst = Math.max(worst, expected > 0 ? Math.abs(got / expected - 1) : Math.abs(got));
        }
        checks.atMost("largest error of cos/r², relative", SHADING_ROUNDING, worst);
        checks.same("shadowed_pixels", asked.tolerance().integer("shadowed_pixels"), dark);
    }

    /** cos/r² of the point, as rounded, that the ray meets first; 0 if it meets nothing. */
    private static double facing(SceneIndex index, Ray ray) {
        int object = index.nearest(ray, SceneIndex.NONE, 0);
        if (object == SceneIndex.NONE) {
            return 0;
        }
        Hit hit = new Hit();
        hit.take(ray);
        index.object(object).shape().complete(ray, hit);
        Vector3 back = new Vector3(ray.originX - hit.x, ray.originY - hit.y, ray.originZ - hit.z);
        double distance = back.length();
        double height = back.dot(new Vector3(hit.normalX, hit.normalY, hit.normalZ));
        return height / (distance * distance * distance);
    }

    private static void highlight(NumericCase asked, Checks checks) {
        double cosine = asked.inputs().number("cos");
        double exponent = asked.inputs().number("exponent");
        if (exponent == 0) {
            checks.notApplicable("the exponent 0 stands for a light that makes no highlight");
            return;
        }
        double value = highlight(cosine, exponent, Stage.plainLight());
        double normalised = highlight(cosine, exponent, Stage.plainLight().normalizeHighlights(true));
        checks.number("value", value);
        checks.note("the thesis' convention, not normalised, is compared; the physical default is the normalised lobe");
        String norm = "energy_norm_(n+1)/(2pi)";
        if (asked.expected().has(norm) && value > Double.MIN_NORMAL) {
            checks.number(norm, normalised / value);
        }
    }

    /** The radiance from a mirror that an eye above looks down on, lit from aside by irradiance 1. */
    private static double highlight(double cosine, double exponent, Settings.Builder settings) {
        double sine = Math.sqrt(Math.max(0, (1 - cosine) * (1 + cosine)));
        Vector3 down = new Vector3(0, -1, 0);
        Material mirror = Material.builder().reflectivity(Color.WHITE).build();
        Scene scene = Scene.builder()
                .camera(Stage.eye(Vector3.UNIT_Y, down))
                .light(new DirectionalLight(new Vector3(sine, -cosine, 0), Color.WHITE, exponent))
                .object("mirror", new Plane(Vector3.ZERO, Vector3.UNIT_Y), mirror)
                .build();
        return Stage.probe(scene, settings).along(down, 0).green();
    }

    private static void directional(NumericCase asked, Checks checks) {
        double irradiance = asked.inputs().number("E");
        double tilt = asked.inputs().number("tilt_deg");
        double radius = asked.inputs().number("disc_radius");
        // Of angles near 90° the difference has all digits.
        double cosine = StrictMath.sin(StrictMath.toRadians(90 - tilt));
        Vector3 direction = new Vector3(StrictMath.sin(StrictMath.toRadians(tilt)), -cosine, 0);
        DirectionalLight sun = new DirectionalLight(direction, Color.grey(irradiance), 0);
        checks.number("E_on_plane", asked.expected().decimal("E_on_plane"), irradiance(sun), "direct");
        Material half = Material.builder().transparency(Color.grey(0.5)).build();
        Shape disc = new Disc(Vector3.ZERO, direction.negated(), 0, radius);
        EnergyLedger ledger = LightRun.of(
                        Scene.builder()
                                .camera(Stage.eye(Vector3.UNIT_Y, Vector3.UNIT_X))
                                .light(sun)
                                .object("disc", disc, half)
                                .object("floor", new Plane(direction.times(4 * radius), direction), Stage.WHITE)
                                .build(),
                        Settings.physical(),
                        "random",
                        RAYS)
                .ledger();
        // The disc keeps half, in each of three colours; of what is sent, the share on the disc is a chance.
        double share = ledger.stored() / (0.5 * ledger.emitted());
        double error = Math.sqrt(share * (1 - share) / RAYS) * ledger.emitted() / 3;
        double got = ledger.stored() / 1.5;
        checks.statistic("emitted_flux", asked.expected().number("emitted_flux"), got, error, 4);
    }
}
