package org.diacaustic.preprocess;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import org.diacaustic.map.Footprint;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.map.Kernel;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Settings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The mesh and photons against closed forms of refracted and mirrored light, each within its own error. */
class ClosedFormsTest {
    private static final int SEEDS = 12;

    /** Triangles around the axis that make a circle. */
    private static final int SPOKES = 60;

    /** With 12 seeds a score is Student's t of 11 degrees of freedom: as seldom beyond 6 as a normal one beyond 4. */
    private static final double LARGEST_SCORE = 6;

    static List<ClosedForms.Form> forms() {
        return ClosedForms.all();
    }

    /** The forms themselves, at the tabulated points. */
    @Test
    void forms_givenTabulatedPlaces_haveTheTabulatedIrradiance() {
        assertForm(ClosedForms.water(false), 0, 0, 0.01269418873);
        assertForm(ClosedForms.water(true), 0.7, 0, 0.01154532649);
        assertForm(ClosedForms.water(true), 0, 2.5, 0.005707301317);
        assertForm(ClosedForms.plate(0), 0.8, 0, 0.01158292582);
        assertForm(ClosedForms.plate(0.6), 0, 0, 0.009979084196);
        assertForm(ClosedForms.ball(false), 0.3224663115, 0, 0.7531654987);
        assertForm(ClosedForms.ball(true), 0.8302755461, 0, 0.2694485175);
        assertForm(ClosedForms.cylinder(), 0.4563718981, 0, 0.6845348354);
        assertForm(ClosedForms.wave(false), Math.PI / 8, 0, 1.247654784);
        assertForm(ClosedForms.wave(true), Math.PI / 8, 0, 1.247654784 * 0.9799406879);
        assertForm(ClosedForms.wave(false), -Math.PI / 8, 0, 0.8343789210);
        // On the axis of the cup, before the cusp, one sheet and t = 1 − x: sinα ÷ (2t − 1), with tanα = 1/2.
        assertForm(ClosedForms.coffeeCup(), 0.3, 0, Math.sqrt(0.2) / 0.4);
        // Beyond it, two more, which come t = x from where cosθ = 1 ÷ 2x.
        assertForm(ClosedForms.coffeeCup(), 0.6, 0, Math.sqrt(0.2) * (1 / 0.2 + 2 / 0.44));
        // Where parallel rays come to the axis behind a ball [OPTICS-02], or a cylinder.
        assertThat(ClosedForms.landing(0.5, 1.391572948889)).isCloseTo(0, within(1e-11));
        assertThat(ClosedForms.landing(0.9, 1.104445568369)).isCloseTo(0, within(1e-11));
    }

    private static void assertForm(ClosedForms.Form form, double x, double z, double expected) {
        assertThat(form.irradiance().applyAsDouble(x, z)).as(form.name()).isCloseTo(expected, within(3e-6 * expected));
    }

    /** Root mean squares of relative errors, and of what the two meshes say of them, over squares around the places. */
    private static double[] errors(ClosedForms.Form form, MeshLight light) {
        double half = 0.2 * form.reach();
        double errors = 0;
        double estimates = 0;
        int count = 0;
        for (double[] place : form.places()) {
            for (int i = 0; i < 25; i++) {
                double x = place[0] + (i % 5 - 2) * 2 * half;
                double z = place[1] + (i / 5 - 2) * 2 * half;
                Footprint footprint = MeshLight.above(0, form.floor(), x - half, z - half, x + half, z + half);
                double exact = ClosedForms.mean(form, x, z, half);
                double found = light.irradiance(footprint);
                double change = found - light.coarseIrradiance(footprint);
                errors += Math.pow(found / exact - 1, 2);
                estimates += Math.pow(change / exact / 3, 2);
                count++;
            }
        }
        return new double[] {Math.sqrt(errors / count), Math.sqrt(estimates / count)};
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("forms")
    void mesh_givenClosedForm_isWithinItsErrorOfIt(ClosedForms.Form form) {
        double[] few = errors(form, MeshLight.of(form.scene(), form.settings(), "own-map", 1 << 14));
        double[] many = errors(form, MeshLight.of(form.scene(), form.settings(), "own-map", 1 << 16));
        // Within what it says of itself, and four times the rays make it at least half as small.
        assertThat(few[0]).isLessThan(2 * few[1]);
        assertThat(many[0]).isLessThan(2 * many[1]).isLessThan(0.5 * few[0]);
    }

    /** Discs around the places, with nothing but the photons' own noise: the expectation is the mean over the disc. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("forms")
    void photons_givenClosedForm_areWithinTheirNoiseOfIt(ClosedForms.Form form) {
        Settings settings = form.settings().toBuilder()
                .maps(MapSettings.builder()
                        .kernel(Kernel.CONSTANT)
                        .estimator(EstimatorName.DENSITY)
                        .gatherRadius(form.reach())
                        .build())
                .build();
        List<IlluminationMap.Lookup> lookups = new ArrayList<>();
        for (int seed = 0; seed < SEEDS; seed++) {
            lookups.add(photons(form, settings, seed));
        }
        for (double[] place : form.places()) {
            double exact = ClosedForms.meanOverDisc(form, place[0], place[1], form.reach());
            double score = score(seed -> gathered(lookups.get(seed), form, place), exact);
            assertThat(score).as("at " + place[0] + ", " + place[1]).isBetween(-LARGEST_SCORE, LARGEST_SCORE);
        }
    }

    private static IlluminationMap.Lookup photons(ClosedForms.Form form, Settings settings, int seed) {
        Workers workers = new Workers(2);
        Settings seeded = settings.toBuilder().seed(1000 + seed).build();
        ForwardPlan plan = Forward.plan(form.scene(), seeded, "random", 20_000);
        ForwardPass pass = new ForwardPass(plan, 0, workers).run();
        return new MapBuilder(plan, workers)
                .build(Forward.camera(), pass.photons(), 0)
                .lookup();
    }

    private static double gathered(IlluminationMap.Lookup lookup, ClosedForms.Form form, double[] place) {
        SurfacePoint at = MeshLight.on(0, true, Vector3.UNIT_Y);
        at.x = place[0];
        at.y = form.floor();
        at.z = place[1];
        Rgb irradiance = new Rgb();
        lookup.irradiance(at, irradiance);
        return irradiance.green;
    }

    /** (mean − expected) in standard errors of the mean. */
    private static double score(IntToDoubleFunction found, double expected) {
        double sum = 0;
        double squares = 0;
        for (int seed = 0; seed < SEEDS; seed++) {
            double off = found.applyAsDouble(seed) - expected;
            sum += off;
            squares += off * off;
        }
        double mean = sum / SEEDS;
        double variance = (squares / SEEDS - mean * mean) / (SEEDS - 1);
        return mean / Math.sqrt(variance);
    }

    /** The power within a circle around the axis: that of triangles which together are as large. */
    private static double powerWithin(MeshLight light, double floor, double radius) {
        double wide = radius * Math.sqrt(2 * Math.PI / SPOKES / Math.sin(2 * Math.PI / SPOKES));
        double power = 0;
        for (int i = 0; i < SPOKES; i++) {
            Footprint wedge = onFloor(new Vector3(0, floor, 0), spoke(floor, wide, i), spoke(floor, wide, i + 1));
            power += light.irradiance(wedge) * wedge.area();
        }
        return power;
    }

    private static Footprint onFloor(Vector3... corners) {
        return MeshLight.polygon(MeshLight.on(0, true, Vector3.UNIT_Y), Vector3.UNIT_Y.negated(), corners);
    }

    private static Vector3 spoke(double floor, double radius, int i) {
        double angle = 2 * Math.PI * (i % SPOKES) / SPOKES;
        return new Vector3(radius * Math.cos(angle), floor, radius * Math.sin(angle));
    }

    /** Of parallel rays of irradiance 1, what lands within a radius behind a unit ball: rings of h add up. */
    private static double exactWithin(double distance, double radius) {
        int steps = 100_000;
        double sum = 0;
        for (int i = 0; i < steps; i++) {
            double h = (i + 0.5) / steps;
            if (Math.abs(ClosedForms.landing(h, distance)) <= radius) {
                sum += 2 * Math.PI * h / steps;
            }
        }
        return sum;
    }

    /**
     * Before and behind its focus, 1.5 from its middle, a ball of glass throws up to three sheets of light: circles hold the
     * power of all rays that land in them [OPTICS-02, 05].
     */
    @ParameterizedTest
    @ValueSource(doubles = {1.2, 1.391572948889, 1.5})
    void mesh_givenBallAndFloorNearTheFocus_hasThePowerWithinCircles(double distance) {
        MeshLight light =
                MeshLight.of(ClosedForms.ballOver(distance), ClosedForms.through(2, false), "own-map", 1 << 16);
        for (double radius : new double[] {0.02, 0.1, 0.4}) {
            double exact = exactWithin(distance, radius);
            assertThat(powerWithin(light, -distance, radius)).isCloseTo(exact, within(2e-3 * exact));
        }
    }

    /** The ring that two of the sheets make where they fold [OPTICS-05], to the width of a footprint. */
    @Test
    void mesh_givenBallAndFloorBeforeTheFocus_isBrightestAtTheRing() {
        double distance = 1.2;
        double ring = 0.07402315473;
        double width = 0.001;
        MeshLight light =
                MeshLight.of(ClosedForms.ballOver(distance), ClosedForms.through(2, false), "own-map", 1 << 16);
        double brightest = 0;
        double place = 0;
        for (int step = 30; step < 150; step++) {
            double irradiance = 0;
            for (int i = 0; i < SPOKES; i++) {
                irradiance += light.irradiance(onFloor(
                        spoke(-distance, step * width, i),
                        spoke(-distance, (step + 1) * width, i),
                        spoke(-distance, (step + 1) * width, i + 1),
                        spoke(-distance, step * width, i + 1)));
            }
            if (irradiance > brightest) {
                brightest = irradiance;
                place = (step + 0.5) * width;
            }
        }
        assertThat(place).isCloseTo(ring, within(width));
    }

    /** A lamp under glass of n = 1.5 sends the part 0.114833 of its light out into the air: that within Snell's window. */
    @Test
    void ledger_givenLampUnderFlatGlass_letsOutWhatFresnelSays() {
        EnergyLedger ledger = MeshLight.of(ClosedForms.lampIn(1.5), ClosedForms.mirrored(), "own-map", 1 << 15)
                .ledger();
        // Of three colours.
        assertThat(ledger.escaped() / 3).isCloseTo(0.11483313644, within(1e-4));
    }
}
