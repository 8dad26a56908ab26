package org.diacaustic.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.diacaustic.render.Eye.clear;
import static org.diacaustic.render.Eye.matt;
import static org.diacaustic.render.Eye.mirror;
import static org.diacaustic.render.Eye.v;

import org.diacaustic.light.Falloff;
import org.diacaustic.light.FlatLight;
import org.diacaustic.light.PointLight;
import org.diacaustic.material.ConstantTexture;
import org.diacaustic.material.Medium;
import org.diacaustic.math.Color;
import org.diacaustic.math.Dielectric;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Sphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Radiances with closed forms. */
class EyePassTest {
    private static final Vector3 UP = Vector3.UNIT_Y;
    private static final Vector3 DOWN = v(0, -1, 0);
    private static final Plane FLOOR = new Plane(Vector3.ZERO, UP);

    @ParameterizedTest
    @CsvSource({
        // A bare floor under a point light of flux 1 at height 2: E = h / (4π (h² + r²)^1.5), and radiance E/π.
        "0, 0.01989436788648691697",
        "1, 0.01423525086834354117",
        "5, 0.001019114861379274091",
    })
    void trace_givenBareFloor_isIrradianceOverPi(double aside, double irradiance) {
        Eye eye = new Eye().object(FLOOR, matt(1)).light(v(0, 2, 0), 1 / (4 * Math.PI));
        double seen = eye.sees(v(aside, 3, 0), DOWN).red();
        assertThat(seen * Math.PI).isCloseTo(irradiance, within(irradiance * 1e-13));
        assertThat(eye.counters().shadowRays()).isEqualTo(1);

        // The thesis leaves π out.
        Eye thesis = new Eye()
                .object(FLOOR, matt(1))
                .light(v(0, 2, 0), 1 / (4 * Math.PI))
                .settings(Settings.thesis().toBuilder());
        assertThat(thesis.sees(v(aside, 3, 0), DOWN).red()).isCloseTo(irradiance, within(irradiance * 1e-13));
    }

    @Test
    void trace_givenLightOnTheFloor_isDarkAndFinite() {
        Eye eye = new Eye().object(FLOOR, matt(1)).light(v(0.3, 0, 0.4), 1);
        assertThat(eye.sees(v(1, 3, 0), DOWN)).isEqualTo(Color.BLACK);
        assertThat(eye.sees(v(0.3, 3, 0.4), DOWN)).isEqualTo(Color.BLACK);
    }

    @Test
    void trace_givenLightAtTheEye_seesNoShadow() {
        // cos / r² at the hit, behind which the box's shadow hides.
        Vector3 at = v(0, 1, 4);
        Eye eye = new Eye()
                .object(new Box(v(-1, 0, -1), v(1, 0.5, 1)), matt(1))
                .object(FLOOR, matt(1))
                .light(at, 1);
        for (double x = -3; x <= 3; x += 0.37) {
            Vector3 direction = v(x, -1, -2).normalized();
            double distance = 1 / -direction.y();
            boolean onFloor = Math.abs(x) > 2.5;
            if (onFloor) {
                assertThat(eye.sees(at, direction).red() * Math.PI)
                        .isCloseTo(-direction.y() / (distance * distance), within(1e-15));
            }
            assertThat(eye.sees(at, direction).red()).isPositive();
        }
    }

    @Test
    void trace_givenAmbient_addsReflectedIrradiance() {
        Eye eye = new Eye().object(FLOOR, matt(0.5).ambient(new ConstantTexture(new Color(1, 2, 3))));
        Color seen = eye.sees(v(0, 1, 0), v(1, -1, 0));
        assertThat(seen.red()).isCloseTo(0.5 / Math.PI, within(1e-16));
        assertThat(seen.blue()).isCloseTo(1.5 / Math.PI, within(3e-16));
    }

    @Test
    void trace_givenNothing_isTheBackground() {
        assertThat(new Eye().background(0.7).sees(Vector3.ZERO, v(1, 2, 3))).isEqualTo(Color.grey(0.7));
    }

    @ParameterizedTest
    @CsvSource({
        // Mirrors that glow with 1, 10⁴ bounces: Σ 0.999^k for k = 0 … 10⁴ = 999.9548718…, and 10001 of perfect ones.
        "0.999, 999.9548718273680406654",
        "1, 10001",
    })
    void trace_givenFacingMirrors_addsUpTenThousandBounces(double reflectivity, double sum) {
        // Ambient irradiance π on a diffuse part of 1 is an emission of 1.
        ConstantTexture glow = new ConstantTexture(Color.grey(Math.PI));
        Eye eye = new Eye()
                .object(FLOOR, mirror(reflectivity).diffuse(Color.WHITE).ambient(glow))
                .object(
                        new Plane(v(0, 1, 0), DOWN),
                        mirror(reflectivity).diffuse(Color.WHITE).ambient(glow));
        eye.settings().maxDepth(10_000);

        assertThat(eye.sees(v(0.1, 0.5, 0.2), DOWN).green()).isCloseTo(sum, within(sum * 9.2e-12));
        assertThat(eye.counters().reflectionRays()).isEqualTo(10_000);
    }

    @Test
    void trace_givenGlassBallInUniformLight_doesNotSeeIt() {
        Eye eye = new Eye().glass(new Sphere(Vector3.ZERO, 1), 1.5).background(1);
        eye.settings().minimumThroughput(1e-10);
        for (double aside : new double[] {0, 0.1, 0.5, 0.8, 0.95, 0.999}) {
            assertThat(eye.sees(v(aside, 0, 5), v(0, 0, -1)).blue())
                    .as("%s from the axis", aside)
                    .isCloseTo(1, within(1e-6));
        }
    }

    @Test
    void trace_givenGlassBallOfFourEvents_missesWhatWasCutOff() {
        // Along the axis, what is missing is what is still inside after the entry and four reflections:
        // 0.96 · 0.04⁴ = 0.0000024576.
        Eye eye = new Eye().glass(new Sphere(Vector3.ZERO, 1), 1.5).background(1);
        eye.settings().maxDepth(5);
        assertThat(eye.sees(v(0, 0, 5), v(0, 0, -1)).red()).isCloseTo(0.9999975424, within(1e-13));
    }

    @Test
    void trace_givenThinSlab_seesAllThatIsReflectedBetweenItsFaces() {
        // (1 − F) / (1 + F) goes through with all reflections, 12/13 for F = 0.04; the rest comes back from the dark.
        Eye eye = new Eye()
                .glass(new Box(v(-9, 0, -9), v(9, 1e-6, 9)), 1.5)
                .object(new Plane(v(0, -1, 0), UP), matt(1).ambient(new ConstantTexture(Color.grey(Math.PI))));
        assertThat(eye.sees(v(0, 1000, 0), DOWN).red()).isCloseTo(12.0 / 13, within(1e-14));
    }

    @Test
    void trace_givenThinAbsorbingSlabFarOff_absorbsTheSlantedPath() {
        // 1 µm at a height of 1000, σ = 10⁵, 60°: a path of 1 µm / √(1 − sin²60° / 1.5²).
        Medium medium = new Medium(1.5, Color.grey(1e5), 0);
        double thickness = (1000 + 1e-6) - 1000;
        double sine = Math.sqrt(0.75) / 1.5;
        double path = thickness / Math.sqrt(1 - sine * sine);
        Eye eye = new Eye()
                .object(new Box(v(-9999, 1000, -9999), v(9999, 1000 + 1e-6, 9999)), clear(medium))
                .background(1)
                .object(new Plane(v(0, 1001, 0), DOWN), matt(1).ambient(new ConstantTexture(Color.grey(Math.PI))));
        // One reflection less is one pass.
        eye.settings().fresnel(false);
        assertThat(eye.sees(Vector3.ZERO, v(Math.sqrt(3), 1, 0)).red())
                .isCloseTo(StrictMath.exp(-1e5 * path), within(4e-7));
    }

    @Test
    void trace_givenAbsorbingBall_followsBeersLaw() {
        Medium medium = new Medium(1, new Color(0, 0.5, 2), 0);
        Eye eye = new Eye().object(new Sphere(Vector3.ZERO, 1), clear(medium)).background(1);
        // The chord at 0.6 from the axis is 1.6 long, and known to a few rounding errors of the coordinates.
        Color seen = eye.sees(v(0.6, 0, 5), v(0, 0, -1));
        assertThat(seen.red()).isEqualTo(1);
        assertThat(seen.green()).isCloseTo(StrictMath.exp(-0.8), within(2e-14));
        assertThat(seen.blue()).isCloseTo(StrictMath.exp(-3.2), within(2e-14));
        // From the middle, one radius.
        assertThat(eye.sees(Vector3.ZERO, v(1, 2, 3)).blue()).isCloseTo(StrictMath.exp(-2), within(1e-15));
    }

    @Test
    void trace_givenEndlessAbsorbingMedium_seesNoBackground() {
        Medium murk = new Medium(1, Color.grey(0.01), 0);
        Eye eye = new Eye().object(FLOOR, clear(murk)).background(1);
        assertThat(eye.sees(v(0, 1, 0), DOWN)).isEqualTo(Color.BLACK);
    }

    @Test
    void trace_givenEyeUnderWater_seesRadianceScaledByTheSquareOfTheIndex() {
        // Straight up out of water, (1 − F) n² of the sky, and F of the bottom, which is black.
        Eye eye = new Eye().glass(FLOOR, 1.33).background(1);
        eye.object(new Plane(v(0, -9, 0), UP), matt(0));
        double f = (0.33 / 2.33) * (0.33 / 2.33);
        assertThat(eye.sees(v(0, -1, 0), UP).red()).isCloseTo((1 - f) * 1.33 * 1.33, within(1e-14));
        // Without the scaling of the radiance, as the thesis has it.
        eye.settings().scaleRadiance(false);
        assertThat(eye.sees(v(0, -1, 0), UP).red()).isCloseTo(1 - f, within(1e-14));
    }

    @Test
    void trace_givenEyeUnderWater_seesSnellsWindow() {
        // At a depth of 2 the window's radius is 2 tan 48.75° = 2.280841283801574; outside it all is mirrored.
        Eye eye = new Eye().glass(FLOOR, 1.33).background(1);
        eye.object(new Plane(v(0, -9, 0), UP), matt(0));
        double edge = 2.280841283801574163;
        assertThat(eye.sees(v(0, -2, 0), v(edge * (1 - 1e-12), 2, 0)).red()).isPositive();
        assertThat(eye.sees(v(0, -2, 0), v(edge * (1 + 1e-12), 2, 0)).red()).isZero();
        assertThat(eye.counters().refractionRays()).isZero();
        assertThat(eye.counters().reflectionRays()).isEqualTo(1);
    }

    @Test
    void trace_givenEyeInGlassBall_startsInGlass() {
        // From the middle: n² (1 − F) Σ F^k = n² of the sky, all reflections included.
        Eye eye = new Eye().glass(new Sphere(Vector3.ZERO, 1), 1.5).background(1);
        assertThat(eye.sees(Vector3.ZERO, v(1, 2, 3)).red()).isCloseTo(2.25, within(1e-12));
    }

    @Test
    void trace_givenTrappedRay_endsAtTheDepthLimit() {
        // (1, 1, 1) meets every face of a cube of glass at 54.7°, beyond the critical 41.8°.
        Eye eye = new Eye().glass(new Box(v(-1, -1, -1), v(1, 1, 1)), 1.5).background(1);
        eye.settings().maxDepth(100_000);
        assertThat(eye.sees(v(0.1, 0.2, 0.3), v(1, 1, 1))).isEqualTo(Color.BLACK);
        assertThat(eye.counters().reflectionRays()).isEqualTo(100_000);
        assertThat(eye.counters().refractionRays()).isZero();
    }

    @Test
    void trace_givenDepthLimit_stopsAfterSoManyBounces() {
        Eye eye = new Eye().object(FLOOR, mirror(1)).object(new Plane(v(0, 1, 0), DOWN), mirror(1));
        for (int depth : new int[] {0, 1, 7}) {
            eye.settings().maxDepth(depth);
            eye.sees(v(0, 0.5, 0), DOWN);
            assertThat(eye.counters().reflectionRays()).isEqualTo(depth);
        }
    }

    @Test
    void trace_givenThroughputLimit_stopsBelowIt() {
        // 0.5^k ≥ 0.1 for k = 1, 2, 3.
        Eye eye = new Eye().object(FLOOR, mirror(0.5)).object(new Plane(v(0, 1, 0), DOWN), mirror(0.5));
        eye.settings().minimumThroughput(0.1);
        eye.sees(v(0, 0.5, 0), DOWN);
        assertThat(eye.counters().reflectionRays()).isEqualTo(3);
    }

    @Test
    void trace_givenSheetWithinGlass_doesNotSeeIt() {
        ConvexPolygon sheet = ConvexPolygon.twoSided(v(-9, 0, -9), v(-9, 0, 9), v(9, 0, 9), v(9, 0, -9));
        Box block = new Box(v(-5, -1, -5), v(5, 1, 5));
        // A glowing tile under the sheet, within the glass.
        Box tile = new Box(v(-1, -0.9, -1), v(1, -0.5, 1));
        ConstantTexture glow = new ConstantTexture(Color.grey(Math.PI));
        Eye without = new Eye().glass(block, 1.5).object(tile, matt(1).ambient(glow));
        Eye with =
                new Eye().glass(block, 1.5).object(tile, matt(1).ambient(glow)).glass(sheet, 1.33);
        Vector3 direction = v(0.2, -1, 0.1);

        assertThat(without.sees(v(0, 3, 0), direction).red()).isPositive();
        assertThat(with.sees(v(0, 3, 0), direction).red())
                .isCloseTo(without.sees(v(0, 3, 0), direction).red(), within(1e-14));
        assertThat(with.counters().refractionRays())
                .isEqualTo(without.counters().refractionRays());
        assertThat(with.counters().reflectionRays())
                .isEqualTo(without.counters().reflectionRays());
    }

    @Test
    void trace_givenEqualIndices_goesStraightOnWithoutReflection() {
        Eye eye = new Eye().glass(new Sphere(Vector3.ZERO, 1), 1).background(1);
        assertThat(eye.sees(v(0.7, 0, 5), v(0, 0, -1))).isEqualTo(Color.WHITE);
        assertThat(eye.counters().reflectionRays()).isZero();
        assertThat(eye.counters().refractionRays()).isEqualTo(2);
    }

    @Test
    void trace_givenHighlight_isNormalisedOrAsInTheThesis() {
        // The eye looks straight down; the light comes from 1 rad aside of the mirrored direction, exponent 1: cos 1.
        Vector3 sun = v(-StrictMath.sin(1), -StrictMath.cos(1), 0);
        Eye eye = new Eye().object(FLOOR, mirror(0.5)).sun(sun, 3, 1);
        double lobe = 0.5403023058681397;
        assertThat(eye.sees(v(0, 1, 0), DOWN).red()).isCloseTo(3 * 0.5 * lobe / Math.PI, within(1e-15));
        eye.settings().normalizeHighlights(false);
        assertThat(eye.sees(v(0, 1, 0), DOWN).red()).isCloseTo(3 * 0.5 * lobe, within(1e-15));
    }

    @Test
    void highlight_givenSharpExponent_keepsItsDigits() {
        // cos(0.001)^(10⁶) = 0.60653…, normalised by (n + 1) / 2π = 159155.1…; a cosine that rounds above 1 is 1.
        Eye eye = new Eye();
        RenderPlan physical = plan(eye.settings().build());
        RenderPlan thesis = plan(Settings.thesis());
        double value = 0.6065306091507150434;
        assertThat(thesis.highlight(0.9999995000000417, 1e6)).isCloseTo(value, within(2e-9));
        assertThat(physical.highlight(0.9999995000000417, 1e6))
                .isCloseTo(value * 159155.1022468384276642, within(4e-4));
        assertThat(thesis.highlight(Math.nextUp(1.0), 1e6)).isEqualTo(1);
        assertThat(thesis.highlight(-0.5, 2)).isZero();
    }

    private static RenderPlan plan(Settings settings) {
        return RenderPlan.of(Scene.builder().camera(Camera.builder().build()).build(), settings);
    }

    @Test
    void trace_givenHighlightThatCannotBeSeen_followsNoShadowRay() {
        // The light stands behind the mirrored direction.
        Eye eye = new Eye().object(FLOOR, mirror(0.5)).sun(v(-0.9, -0.1, 0), 3, 400);
        eye.sees(v(0, 1, 0), v(-0.9, -0.1, 0));
        assertThat(eye.counters().shadowRays()).isZero();
        eye.sees(v(0, 1, 0), v(0.9, -0.1, 0));
        assertThat(eye.counters().shadowRays()).isEqualTo(1);
    }

    @Test
    void trace_givenAreaLight_seesItAndIsLitByIt() {
        // Radiance 1 of a disc that subtends 45° below its centre: E = π sin²45°, and ρE/π = 1/4 on grey.
        FlatLight disc = FlatLight.disc(v(0, 1, 0), DOWN, 1, Color.WHITE, new Falloff.InverseSquare(), 20_000);
        Eye eye = new Eye().object(FLOOR, matt(0.5));
        eye.scene().light(disc);
        assertThat(eye.sees(v(0, 0.5, 0), UP)).isEqualTo(Color.WHITE);
        assertThat(eye.sees(v(0, 3, 0), v(0.9, -1, 0)).red())
                .as("its dark side hides nothing")
                .isPositive();
        assertThat(eye.sees(v(0, 0.5, 0), DOWN).red()).isCloseTo(0.25, within(1e-4));
        assertThat(eye.counters().shadowRays()).isEqualTo(20_000);
    }

    @Test
    void trace_givenWeakenedPath_takesFewerSamplesOfAreaLights() {
        FlatLight disc = FlatLight.disc(v(0, 1, 0), DOWN, 1, Color.WHITE, new Falloff.InverseSquare(), 1000);
        Eye eye = new Eye().object(FLOOR, matt(0.5)).object(new Plane(v(3, 0, 0), v(-1, 0, 0)), mirror(0.1));
        eye.scene().light(disc);
        eye.sees(v(2, 0.5, 0), v(2, -0.5, 0));
        assertThat(eye.counters().shadowRays()).isEqualTo(100);
    }

    @Test
    void trace_givenPlateBetweenLightAndFloor_isFilteredAlongTheLine() {
        // Straight through 0.5 of glass with σ = 0.6 lie 0.9216 exp(−0.3) = 0.68273807…
        Eye eye = new Eye()
                .object(FLOOR, matt(1))
                .object(new Box(v(-9, 1, -9), v(9, 1.5, 9)), clear(new Medium(1.5, Color.grey(0.6), 0)))
                .light(v(0, 2.5, 0), 1);
        double expected = 0.68273807218027119295 / 6.25 / Math.PI;
        assertThat(eye.sees(v(0, 0.5, 0), DOWN).red()).isCloseTo(expected, within(expected * 1e-13));
        eye.settings().attenuate(false).fresnel(false);
        assertThat(eye.sees(v(0, 0.5, 0), DOWN).red()).isCloseTo(1 / 6.25 / Math.PI, within(1e-15));
    }

    @Test
    void trace_givenInterface_splitsByFresnelAtEveryAngle() {
        // Above water 1, below 0: what is seen looking down is F.
        Eye eye = new Eye()
                .glass(FLOOR, 1.33)
                .object(new Plane(v(0, -1, 0), UP), matt(0))
                .background(1);
        Dielectric water = new Dielectric();
        for (double sine : new double[] {0, 0.3, 0.9, 0.999}) {
            double cosine = Math.sqrt(1 - sine * sine);
            water.evaluate(cosine, 1, 1.33);
            assertThat(eye.sees(v(0, 1, 0), v(sine, -cosine, 0)).red()).isCloseTo(water.reflectance, within(1e-14));
        }
    }

    @Test
    void trace_givenTotalInternalReflectionDropped_countsNeitherRay() {
        Eye eye = new Eye().glass(FLOOR, 1.33).background(1).settings(Settings.thesis().toBuilder());
        assertThat(eye.sees(v(0, -1, 0), v(2, 1, 0))).isEqualTo(Color.BLACK);
        assertThat(eye.counters().reflectionRays() + eye.counters().refractionRays())
                .isZero();
    }

    @Test
    void trace_givenHighlightLightBehindTheHorizon_staysDark() {
        Eye eye = new Eye().object(FLOOR, matt(1));
        eye.scene().light(new PointLight(v(0, -1, 0), Color.WHITE));
        assertThat(eye.sees(v(0, 1, 0), DOWN)).isEqualTo(Color.BLACK);
        assertThat(eye.counters().shadowRays()).isZero();
    }
}
