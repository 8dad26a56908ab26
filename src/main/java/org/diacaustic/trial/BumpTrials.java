package org.diacaustic.trial;

import org.diacaustic.light.DirectionalLight;
import org.diacaustic.material.BumpMap;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.material.ScatterRules;
import org.diacaustic.material.Scattering;
import org.diacaustic.material.Surface;
import org.diacaustic.material.TransportMode;
import org.diacaustic.material.Wave;
import org.diacaustic.math.Color;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.diacaustic.preprocess.EnergyLedger;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Plane;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;
import org.diacaustic.stability.Values;

/** Normals that bumps tilt. */
final class BumpTrials {
    private static final double ROUNDING = 4 * Math.ulp(1.0);
    private static final double LEDGER_ROUNDING = 1e-13;
    private static final long RAYS = 500;

    /** Naive directions that pass the surface at a sine below this are bent away from it. */
    private static final double HORIZON = 0x1p-10;

    private BumpTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "bump_refract",
                "The scattering that every surface of a render asks. Mirrored light must leave on the near side, refracted light on"
                        + " the far side, and together they must be all of it; where the naive directions do so by more than"
                        + " 2⁻¹⁰ and the normal faces the ray, they must be those. A bump that is zero must change no bit. If a"
                        + " height can tilt the normal so, a forward pass over a surface with it must lose no flux.",
                BumpTrials::refract);
        operations.add(
                "wave_normal",
                "The normal that a material with a wave gives to a completed hit, and the slope that it stands for.",
                BumpTrials::wave);
    }

    private static void refract(NumericCase asked, Checks checks) {
        Vector3 incident = Stage.vector(asked.inputs().vector("I"));
        Vector3 geometric = Stage.vector(asked.inputs().vector("Ng"));
        Vector3 shading = Stage.vector(asked.inputs().vector("Ns"));
        double near = asked.inputs().number("n1");
        double far = asked.inputs().number("n2");
        Scattering got = scattering(incident, geometric, shading, near, far);
        Vector3 mirrored = new Vector3(got.reflectedX, got.reflectedY, got.reflectedZ);
        Vector3 refracted = new Vector3(got.transmittedX, got.transmittedY, got.transmittedZ);
        int side = incident.dot(geometric) < 0 ? 1 : -1;
        boolean passes = !got.totalInternalReflection;
        checks.number("R + T", 1, got.reflectance.red + got.transmittance.red, ROUNDING);
        if (got.reflectance.red > 0) {
            checks.holds("mirrored light leaves on the near side", side * mirrored.dot(geometric) > 0);
            checks.number("length of the mirrored direction", 1, mirrored.length(), ROUNDING);
        }
        if (passes) {
            checks.holds("refracted light leaves on the far side", side * refracted.dot(geometric) < 0);
            checks.number("length of the refracted direction", 1, refracted.length(), ROUNDING);
        }
        if (passes && isPlain(asked.expected(), geometric, -side * incident.dot(shading), side)) {
            checks.numbers("naive_refraction", new double[] {refracted.x(), refracted.y(), refracted.z()}, "dir");
        } else {
            checks.note("the normal or the direction is bent back to the horizon");
        }
        if (shading.equals(geometric)) {
            Scattering flat = scattering(incident, geometric, null, near, far);
            checks.holds("as without a bump, to the bit", sameBits(got, flat));
            checks.holds("no slope leaves the normal as it is", keepsNormal(geometric));
        }
        conserves(incident, geometric, shading, near, far, checks);
    }

    /** Whether nothing is to be bent: the normal faces the ray, and the naive direction leaves on the far side. */
    private static boolean isPlain(Values expected, Vector3 geometric, double cosIncident, int side) {
        return expected.has("naive_refraction")
                && cosIncident > HORIZON
                && side * Stage.vector(expected.vector("naive_refraction")).dot(geometric) < -HORIZON;
    }

    /** @param shading null for a surface without a bump, else its normal */
    private static Scattering scattering(
            Vector3 incident, Vector3 geometric, Vector3 shading, double near, double far) {
        Ray ray = new Ray();
        ray.set(Vector3.ZERO, incident);
        Hit hit = new Hit();
        hit.setNormal(geometric.x(), geometric.y(), geometric.z());
        Surface surface = new Surface();
        Material.builder().transparency(Color.WHITE).build().evaluate(hit, surface);
        if (shading != null) {
            hit.shadingX = shading.x();
            hit.shadingY = shading.y();
            hit.shadingZ = shading.z();
        }
        int side = incident.dot(geometric) < 0 ? 1 : -1;
        Scattering scattering = new Scattering();
        scattering.evaluate(ScatterRules.PHYSICAL, TransportMode.FLUX, ray, hit, surface, side, near, far);
        return scattering;
    }

    private static boolean keepsNormal(Vector3 normal) {
        Hit hit = new Hit();
        hit.setNormal(normal.x(), normal.y(), normal.z());
        Material.builder().bump(new Tilt(Vector3.ZERO)).build().evaluate(hit, new Surface());
        return hit.shadingX == normal.x() && hit.shadingY == normal.y() && hit.shadingZ == normal.z();
    }

    private static boolean sameBits(Scattering a, Scattering b) {
        return a.reflectance.red == b.reflectance.red
                && a.transmittance.red == b.transmittance.red
                && a.reflectedX == b.reflectedX
                && a.reflectedY == b.reflectedY
                && a.reflectedZ == b.reflectedZ
                && a.transmittedX == b.transmittedX
                && a.transmittedY == b.transmittedY
                && a.transmittedZ == b.transmittedZ;
    }

    /** Sends parallel light along the ray onto a square with the bump, and looks at its ledger. */
    private static void conserves(
            Vector3 incident, Vector3 geometric, Vector3 shading, double near, double far, Checks checks) {
        double along = shading.dot(geometric);
        if (!(along > 0) || !(incident.dot(geometric) < 0)) {
            return;
        }
        Material material = Material.builder()
                .transparency(Color.WHITE)
                .outside(Medium.of(near))
                .inside(Medium.of(far))
                .bump(new Tilt(geometric.minus(shading.times(1 / along))))
                .build();
        Vector3 u = geometric.perpendicular();
        Vector3 v = geometric.cross(u);
        Scene scene = Scene.builder()
                .camera(Stage.eye(geometric.times(3), geometric.negated()))
                .light(new DirectionalLight(incident, Color.WHITE, 0))
                .object("square", ConvexPolygon.twoSided(u, v, u.negated(), v.negated()), material)
                .object("floor", new Plane(geometric.times(-2), geometric), Stage.WHITE)
                .build();
        EnergyLedger ledger =
                LightRun.of(scene, Settings.physical(), "random", RAYS).ledger();
        double spent = ledger.stored() + ledger.absorbed() + ledger.escaped() + ledger.cut();
        checks.holds("light is sent", ledger.emitted() > 0);
        checks.number("flux accounted for", 1, spent / ledger.emitted(), LEDGER_ROUNDING);
    }

    /** A height that rises evenly. */
    private record Tilt(Vector3 slope) implements BumpMap {
        @Override
        public void addGradient(Hit hit, Gradient gradient) {
            gradient.add(slope.x(), slope.y(), slope.z());
        }
    }

    private static void wave(NumericCase asked, Checks checks) {
        double waveNumber = asked.inputs().number("k");
        double height = asked.inputs().number("A");
        if (!(Math.abs(waveNumber) > 0)) {
            checks.notApplicable("a wave without waves is refused, with the rule: a wave number must be positive");
            return;
        }
        // sin(−k·x) runs the other way.
        Vector3 direction = waveNumber > 0 ? Vector3.UNIT_X : Vector3.UNIT_X.negated();
        Material material = Material.builder()
                .bump(new Wave(direction, Math.abs(waveNumber), height, 0))
                .build();
        Hit hit = new Hit();
        hit.setPoint(asked.inputs().number("x"), 0, 0, 0);
        hit.setNormal(0, 1, 0);
        material.evaluate(hit, new Surface());
        checks.numbers("N", new double[] {hit.shadingX, hit.shadingY, hit.shadingZ}, "N");
        double steepness = Math.abs(asked.expected().number("slope"));
        // An error of the normal weighs 1 + slope² in the slope.
        double tolerance = asked.tolerance().number("N_abs") * (1 + steepness * steepness);
        checks.number("slope", asked.expected().number("slope"), -hit.shadingX / hit.shadingY, tolerance);
    }
}
