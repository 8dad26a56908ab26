package org.diacaustic.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.diacaustic.math.Color;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.SampleStream;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Disc;
import org.diacaustic.shape.Hit;
import org.junit.jupiter.api.Test;

class ScatteringTest {
    private static final Vector3 UP = Vector3.UNIT_Y;
    private static final ScatterRules FIXED_SPLIT =
            new ScatterRules(false, false, true, ScatterRules.BackFacingBump.BEND);

    private final Scattering scattering = new Scattering();
    private final Surface surface = new Surface();
    private ScatterRules rules = ScatterRules.PHYSICAL;
    private TransportMode mode = TransportMode.RADIANCE;

    ScatteringTest() {
        surface.transparency.set(Color.WHITE);
    }

    @Test
    void evaluate_givenMirror_reflectsEachColourByItsPart() {
        surface.transparency.set(Color.BLACK);
        surface.reflectivity.set(0.2, 0.4, 0.6);
        Vector3 incident = new Vector3(0.6, -0.64, 0.48);

        arrive(incident, UP, UP, 1, 1, 1);

        assertThat(reflected()).isEqualTo(new Vector3(0.6, 0.64, 0.48));
        assertColor(scattering.reflectance, 0.2, 0.4, 0.6);
        assertColor(scattering.transmittance, 0, 0, 0);
    }

    @Test
    void evaluate_givenThesisEquation3_bendsTowardsTheNormal() {
        // From 30° in air to 19.47° in glass: T = (1/3, −√8/3); the same whichever side of the surface its normal is
        // on.
        Vector3 incident = new Vector3(0.5, -0.8660254037844386, 0);
        for (int side : new int[] {1, -1}) {
            Vector3 normal = UP.times(side);
            arrive(incident, normal, normal, side, 1, 1.5);

            assertClose(transmitted(), new Vector3(0.3333333333333333478, -0.9428090415820633607, 0), 1e-15);
            assertThat(transmitted().length()).isCloseTo(1, within(1e-15));
        }
    }

    @Test
    void evaluate_givenFresnel_splitsByReflectanceReflectivityAndTransparency() {
        surface.reflectivity.set(0.1, 0.2, 0.3);
        surface.transparency.set(0.9, 0.7, 0.5);
        mode = TransportMode.FLUX;

        arrive(UP.negated(), UP, UP, 1, 1, 1.5);

        // F = (0.5 / 2.5)² = 0.04; R = F + (1 − F)·r and T = (1 − F)·t.
        assertColor(scattering.reflectance, 0.04 + 0.096, 0.04 + 0.192, 0.04 + 0.288);
        assertColor(scattering.transmittance, 0.96 * 0.9, 0.96 * 0.7, 0.96 * 0.5);
    }

    @Test
    void evaluate_givenFixedSplit_takesTheCoefficientsAlone() {
        rules = FIXED_SPLIT;
        mode = TransportMode.FLUX;
        surface.reflectivity.set(0.1, 0.2, 0.3);
        surface.transparency.set(0.9, 0.7, 0.5);

        arrive(UP.negated(), UP, UP, 1, 1, 1.5);

        assertColor(scattering.reflectance, 0.1, 0.2, 0.3);
        assertColor(scattering.transmittance, 0.9, 0.7, 0.5);
    }

    @Test
    void evaluate_givenRadiance_scalesByTheSquareOfTheIndicesButNotFlux() {
        arrive(UP.negated(), UP, UP, 1, 1, 1.5);
        // Radiance in glass is 1.5² times that in air, so the eye in air sees 1/1.5² of it.
        assertColor(scattering.transmittance, 0.96 / 2.25, 0.96 / 2.25, 0.96 / 2.25);

        arrive(UP.negated(), UP, UP, 1, 1.5, 1);
        assertColor(scattering.transmittance, 0.96 * 2.25, 0.96 * 2.25, 0.96 * 2.25);

        mode = TransportMode.FLUX;
        arrive(UP.negated(), UP, UP, 1, 1, 1.5);
        assertColor(scattering.transmittance, 0.96, 0.96, 0.96);

        mode = TransportMode.RADIANCE;
        rules = ScatterRules.THESIS;
        arrive(UP.negated(), UP, UP, 1, 1, 1.5);
        assertColor(scattering.transmittance, 1, 1, 1);
    }

    @Test
    void evaluate_givenTotalInternalReflection_reflectsAllOrDropsIt() {
        // 60° in glass is beyond the critical 41.8°.
        Vector3 steep = new Vector3(0.8660254037844386, -0.5, 0);
        surface.reflectivity.set(Color.grey(0.1));
        surface.transparency.set(Color.grey(0.8));

        arrive(steep, UP, UP, 1, 1.5, 1);
        assertThat(scattering.totalInternalReflection).isTrue();
        assertColor(scattering.reflectance, 1, 1, 1);
        assertColor(scattering.transmittance, 0, 0, 0);

        rules = FIXED_SPLIT;
        arrive(steep, UP, UP, 1, 1.5, 1);
        assertColor(scattering.reflectance, 0.9, 0.9, 0.9);

        for (boolean fresnel : new boolean[] {false, true}) {
            rules = new ScatterRules(fresnel, true, true, ScatterRules.BackFacingBump.FLIP);
            arrive(steep, UP, UP, 1, 1.5, 1);
            assertColor(scattering.reflectance, 0.1, 0.1, 0.1);
            assertColor(scattering.transmittance, 0, 0, 0);
        }
    }

    @Test
    void evaluate_givenEqualIndices_leavesTheDirectionToTheBit() {
        Vector3 incident = new Vector3(0.1, -0.7, 0.3).normalized();
        Vector3 bumped = new Vector3(0.3, 1, -0.2).normalized();

        arrive(incident, UP, bumped, 1, 1.33, 1.33);

        assertThat(transmitted()).isEqualTo(incident);
        assertColor(scattering.reflectance, 0, 0, 0);
        assertColor(scattering.transmittance, 1, 1, 1);
    }

    @Test
    void evaluate_givenBumpTowardsTheRay_keepsBothDirections() {
        // The normal leans 40° towards the ray; both directions stay on their sides, so nothing is bent.
        arrive(
                new Vector3(0.9396926207859084, -0.3420201433256687, 0),
                UP,
                new Vector3(-0.6427876096865394, 0.766044443118978, 0),
                1,
                1,
                1.5);

        assertThat(reflected().y()).isCloseTo(0.9848077530122080507, within(1e-14));
        assertClose(transmitted(), new Vector3(0.8613741179357176030, -0.5079710906640893299, 0), 1e-14);
    }

    @Test
    void evaluate_givenNoBump_isTheFlatInterface() {
        arrive(new Vector3(0.6427876096865394, -0.766044443118978, 0), UP, UP, 1, 1, 1.33);

        assertThat(reflected().y()).isCloseTo(0.7660444431189780, within(1e-14));
        assertClose(transmitted(), new Vector3(0.4832989546515333264, -0.8754553788930279531, 0), 1e-14);
    }

    @Test
    void evaluate_givenBumpThatFacesAway_keepsEachDirectionOnItsSide() {
        for (ScatterRules.BackFacingBump rule : ScatterRules.BackFacingBump.values()) {
            rules = new ScatterRules(true, false, true, rule);
            // The normal leans 30° away from a grazing ray: unbent, both directions would be on the wrong side.
            arrive(
                    new Vector3(0.984807753012208, -0.17364817766693036, 0),
                    UP,
                    new Vector3(0.5, 0.8660254037844386, 0),
                    1,
                    1,
                    1.33);
            assertOnTheirSides();
            // A normal that leans 89.9°: unbent, the mirrored ray would go straight into the surface.
            arrive(UP.negated(), UP, new Vector3(0.9999984769132877, 0.0017453283658982097, 0), 1, 1, 1.33);
            assertOnTheirSides();
        }
    }

    @Test
    void evaluate_givenRandomBumps_keepsEachDirectionOnItsSideAndLosesNothing() {
        SampleStream random = new SampleStream();
        random.start(1, 0, 0);
        mode = TransportMode.FLUX;
        for (ScatterRules.BackFacingBump rule : ScatterRules.BackFacingBump.values()) {
            rules = new ScatterRules(true, false, true, rule);
            for (int i = 0; i < 20_000; i++) {
                Vector3 incident = direction(random);
                Vector3 down = incident.y() > 0 ? incident.negated() : incident;
                arrive(down, UP, direction(random), 1, i % 2 == 0 ? 1 : 1.5, i % 2 == 0 ? 1.5 : 1);

                assertThat(scattering.reflectance.red + scattering.transmittance.red)
                        .isCloseTo(1, within(1e-15));
                assertThat(reflected().y()).isPositive();
                assertThat(reflected().length()).isCloseTo(1, within(1e-14));
                if (!scattering.totalInternalReflection) {
                    assertThat(transmitted().y()).isNegative();
                    assertThat(transmitted().length()).isCloseTo(1, within(1e-14));
                }
            }
        }
    }

    @Test
    void evaluate_givenBumpThatPassesTheHorizon_doesNotJump() {
        // The normal turns by 1e-5 rad a step through where it faces away from the ray, and where the mirrored ray
        // would enter the surface. Nothing that is mirrored or refracted may turn by more than a few thousand steps'
        // worth at once: bending happens within 2^-10 rad of the horizon.
        Vector3 incident = new Vector3(0.984807753012208, -0.17364817766693036, 0);
        double step = 1e-5;
        Vector3 lastReflected = null;
        Vector3 lastTransmitted = null;
        double lastReflectance = Double.NaN;
        for (double angle = -1.2; angle < 1.2; angle += step) {
            arrive(incident, UP, new Vector3(StrictMath.sin(angle), StrictMath.cos(angle), 0), 1, 1, 1.33);
            if (lastReflected != null) {
                assertThat(reflected().minus(lastReflected).length())
                        .as("mirrored at %s", angle)
                        .isLessThan(0.02);
                assertThat(transmitted().minus(lastTransmitted).length())
                        .as("refracted at %s", angle)
                        .isLessThan(0.02);
                assertThat(Math.abs(scattering.reflectance.red - lastReflectance))
                        .as("reflectance at %s", angle)
                        .isLessThan(1e-3);
            }
            lastReflected = reflected();
            lastTransmitted = transmitted();
            lastReflectance = scattering.reflectance.red;
        }
    }

    @Test
    void evaluate_givenThesisRule_turnsTheNormalRound() {
        // A normal that faces away scatters as its opposite does.
        rules = new ScatterRules(false, true, false, ScatterRules.BackFacingBump.FLIP);
        Vector3 incident = new Vector3(0.8, -0.6, 0);
        Vector3 away = new Vector3(0.96, 0.28, 0);

        arrive(incident, UP, away, 1, 1, 1.33);
        Vector3 flipped = transmitted();
        arrive(incident, UP, away.negated(), 1, 1, 1.33);

        assertThat(flipped).isEqualTo(transmitted());
    }

    @Test
    void evaluate_givenThousandParallelSlabs_comesOutAsItWentIn() {
        // Each slab and each gap is 1 mm; a ray 60° from the normal moves by tan 60° mm in a gap and by tan θ mm in a
        // slab, sin θ = sin 60° / 1.5: 2.439157588755424753 after 1000 of both.
        Vector3 direction = new Vector3(0.8660254037844386, -0.5, 0);
        Ray ray = new Ray();
        Hit hit = new Hit();
        ray.set(Vector3.ZERO, direction);
        int events = 0;
        double x = 0;
        for (int i = 0; i < 2000; i++) {
            Disc face = new Disc(new Vector3(0, -0.001 * i, 0), UP, 10);
            // The first face is met where the ray starts.
            if (i > 0) {
                assertThat(face.intersect(ray)).isTrue();
                hit.take(ray);
                face.complete(ray, hit);
            } else {
                hit.setPoint(0, 0, 0, 0);
                hit.setNormal(0, 1, 0);
            }
            events++;
            boolean enters = i % 2 == 0;
            scattering.evaluate(rules, mode, ray, hit, surface, 1, enters ? 1 : 1.5, enters ? 1.5 : 1);
            x = hit.x;
            ray.set(new Vector3(hit.x, hit.y, hit.z), transmitted());
        }
        assertThat(events).isEqualTo(2000);
        assertClose(transmitted(), direction, 2e-12);
        // The last gap, to the next slab, is not walked above.
        x += 0.001 * -transmitted().x() / transmitted().y();
        assertThat(x).isCloseTo(2.439157588755424753, within(2.4e-11));
    }

    @Test
    void evaluate_givenTheRefractedRayBackwards_comesBackTheWayItCame() {
        mode = TransportMode.FLUX;
        SampleStream random = new SampleStream();
        random.start(6, 0, 0);
        for (int i = 0; i < 20_000; i++) {
            Vector3 incident = direction(random);
            int side = incident.y() < 0 ? 1 : -1;
            double far = 0.4 + 2.6 * random.nextDouble();
            arrive(incident, UP, UP, side, 1, far);
            if (scattering.totalInternalReflection) {
                continue;
            }
            double fraction = scattering.transmittance.green;
            Vector3 there = transmitted();
            arrive(there.negated(), UP, UP, -side, far, 1);
            // Flat to the surface a small change of the one angle is a large one of the other.
            double magnified = 1 / Math.min(Math.abs(incident.y()), Math.abs(there.y()));
            assertClose(transmitted(), incident.negated(), 16 * Math.ulp(1.0) * magnified);
            assertThat(scattering.transmittance.green).isCloseTo(fraction, within(1e-14 * magnified));
        }
    }

    private void arrive(Vector3 incident, Vector3 normal, Vector3 shading, int side, double nNear, double nFar) {
        Ray ray = new Ray();
        ray.set(Vector3.ZERO, incident);
        Hit hit = new Hit();
        hit.setNormal(normal.x(), normal.y(), normal.z());
        hit.shadingX = shading.x();
        hit.shadingY = shading.y();
        hit.shadingZ = shading.z();
        scattering.evaluate(rules, mode, ray, hit, surface, side, nNear, nFar);
    }

    private static Vector3 direction(SampleStream random) {
        double z = 2 * random.nextDouble() - 1;
        double angle = 2 * Math.PI * random.nextDouble();
        double ring = Math.sqrt(1 - z * z);
        return new Vector3(ring * StrictMath.cos(angle), z, ring * StrictMath.sin(angle)).normalized();
    }

    private Vector3 reflected() {
        return new Vector3(scattering.reflectedX, scattering.reflectedY, scattering.reflectedZ);
    }

    private Vector3 transmitted() {
        return new Vector3(scattering.transmittedX, scattering.transmittedY, scattering.transmittedZ);
    }

    private void assertOnTheirSides() {
        assertThat(reflected().y()).isPositive();
        assertThat(transmitted().y()).isNegative();
        assertThat(reflected().isFinite() && transmitted().isFinite()).isTrue();
    }

    private static void assertColor(Rgb color, double red, double green, double blue) {
        assertThat(color.red).isCloseTo(red, within(4e-16));
        assertThat(color.green).isCloseTo(green, within(4e-16));
        assertThat(color.blue).isCloseTo(blue, within(4e-16));
    }

    private static void assertClose(Vector3 actual, Vector3 expected, double error) {
        assertThat(actual.x()).isCloseTo(expected.x(), within(error));
        assertThat(actual.y()).isCloseTo(expected.y(), within(error));
        assertThat(actual.z()).isCloseTo(expected.z(), within(error));
    }
}
