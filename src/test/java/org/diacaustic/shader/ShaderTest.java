package org.diacaustic.shader;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.diacaustic.light.LightSample;
import org.diacaustic.light.PointLight;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.material.ScatterRules;
import org.diacaustic.math.Color;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.MediumLocator;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.Disc;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.junit.jupiter.api.Test;

/** What arrives at the origin, on an opaque floor, from a light above. */
class ShaderTest {
    private static final Vector3 ABOVE = new Vector3(0, 10, 0);
    /** 60° from the normal of the floor. */
    private static final Vector3 ASIDE = new Vector3(10 * Math.sqrt(3), 10, 0);

    private static final Shader BLOCKING = new NonTransparentShader();
    private static final Shader FILTERING = new NonRefractiveShader(ScatterRules.THESIS, false);
    private static final Shader ATTENUATING = new NonRefractiveShader(ScatterRules.THESIS, true);
    private static final Shader PHYSICAL = new NonRefractiveShader(ScatterRules.PHYSICAL, true);

    @Test
    void transmit_givenNothingInBetween_letsAllArrive() {
        for (Shader shader : new Shader[] {BLOCKING, FILTERING, PHYSICAL}) {
            assertArrives(shader, ASIDE, 1, 1, 1);
        }
    }

    @Test
    void transmit_givenOpaqueObject_stopsAll() {
        SceneObject screen = opaque(disc(2));
        for (Shader shader : new Shader[] {BLOCKING, FILTERING, PHYSICAL}) {
            assertThat(arrives(shader, ABOVE, screen)).isEqualTo(Color.BLACK);
        }
        // What lies behind the light stops nothing.
        assertArrives(FILTERING, ABOVE, 1, 1, 1, opaque(disc(11)));
    }

    @Test
    void transmit_givenTransparentObject_stopsOrFilters() {
        SceneObject sheet = clear(disc(2), new Color(0.9, 0.5, 0.1), Medium.VACUUM);
        assertThat(arrives(BLOCKING, ABOVE, sheet)).isEqualTo(Color.BLACK);
        assertArrives(FILTERING, ABOVE, 0.9, 0.5, 0.1, sheet);
    }

    @Test
    void transmit_givenSeveralFilters_isTheirProductForEachSurface() {
        SceneObject sheet = clear(disc(2), new Color(0.9, 0.5, 0.1), Medium.VACUUM);
        SceneObject block = clear(slab(3, 4), new Color(0.5, 0.8, 1), Medium.VACUUM);
        // A block has two surfaces.
        assertArrives(FILTERING, ASIDE, 0.9 * 0.25, 0.5 * 0.64, 0.1, sheet, block);
        assertArrives(FILTERING, ASIDE, 0.9 * 0.25, 0.5 * 0.64, 0.1, block, sheet);
    }

    @Test
    void transmit_givenFilters_multipliesInTheOrderInWhichLightMeetsThem() {
        // Products of these three differ in the last bit with the order; the light meets 0.7 first.
        SceneObject low = clear(disc(2), Color.grey(0.1), Medium.VACUUM);
        SceneObject middle = clear(disc(3), Color.grey(0.3), Medium.VACUUM);
        SceneObject high = clear(disc(4), Color.grey(0.7), Medium.VACUUM);
        double expected = 0.7 * 0.3 * 0.1;
        assertThat(expected).isNotEqualTo(0.1 * 0.3 * 0.7);
        assertThat(arrives(FILTERING, ABOVE, low, middle, high).red()).isEqualTo(expected);
        assertThat(arrives(FILTERING, ABOVE, middle, high, low).red()).isEqualTo(expected);
    }

    @Test
    void transmit_givenAbsorbingPlate_attenuatesByTheSlantedPath() {
        // exp(−σ d / cos θ): 0.6 per unit over 0.5, at 60° twice as far.
        SceneObject plate = clear(slab(2, 2.5), Color.WHITE, new Medium(1, new Color(0.6, 0, 1.2), 0));
        assertArrives(ATTENUATING, ASIDE, StrictMath.exp(-0.6), 1, StrictMath.exp(-1.2), plate);
        assertArrives(FILTERING, ASIDE, 1, 1, 1, plate);
    }

    @Test
    void transmit_givenGlassPlate_losesWhatFresnelReflects() {
        // 0.96² = 0.9216 without absorption, and 0.68273807218027119295 with exp(−0.3).
        assertArrives(PHYSICAL, ABOVE, 0.9216, 0.9216, 0.9216, clear(slab(2, 2.5), Color.WHITE, Medium.of(1.5)));
        double through = 0.68273807218027119295;
        SceneObject grey = clear(slab(2, 2.5), Color.WHITE, new Medium(1.5, Color.grey(0.6), 0));
        assertArrives(PHYSICAL, ABOVE, through, through, through, grey);
    }

    @Test
    void transmit_givenOverlappingMedia_absorbsWhatFillsEachPart() {
        // Of priority, the first fills 1 to 3 and the second 3 to 4, in whatever order they are listed.
        SceneObject first = clear(slab(1, 3), Color.WHITE, new Medium(1, Color.grey(0.1), 2));
        SceneObject second = clear(slab(2, 4), Color.WHITE, new Medium(1, Color.grey(0.5), 1));
        double through = StrictMath.exp(-0.1 * 2 - 0.5 * 1);
        assertArrives(ATTENUATING, ABOVE, through, through, through, first, second);
        assertArrives(ATTENUATING, ABOVE, through, through, through, second, first);
    }

    @Test
    void transmit_givenInvisibleBoundary_filtersNothingThere() {
        // The second is wholly inside the first, of higher priority.
        SceneObject around = clear(slab(1, 4), Color.grey(0.5), new Medium(1.5, Color.BLACK, 2));
        SceneObject within = clear(slab(2, 3), Color.grey(0.1), new Medium(1.33, Color.BLACK, 1));
        double through = 0.25 * 0.96 * 0.96;
        assertArrives(PHYSICAL, ABOVE, through, through, through, around, within);
    }

    @Test
    void transmit_givenLitPointAndLightInsideMedia_followsThemFromOneToTheOther() {
        // The lit point lies under water that reaches up to 1, and the light in the middle of a ball of glass of radius
        // 2.
        SceneObject water = clear(slab(-1, 1), Color.WHITE, new Medium(1.33, Color.grey(0.2), 0));
        SceneObject ball = clear(new Sphere(ABOVE, 2), Color.WHITE, new Medium(1.5, Color.grey(0.4), 0));
        double waterSurface = 1 - (0.33 / 2.33) * (0.33 / 2.33);
        double through = StrictMath.exp(-0.2 - 0.8) * 0.96 * waterSurface;
        assertArrives(PHYSICAL, ABOVE, through, through, through, water, ball);
    }

    @Test
    void transmit_givenManyCrossings_keepsThemAll() {
        SceneObject[] sheets = new SceneObject[50];
        for (int i = 0; i < 50; i++) {
            sheets[i] = clear(disc(1 + 7 * i % 50 * 0.1), Color.grey(0.99), Medium.VACUUM);
        }
        double through = StrictMath.pow(0.99, 50);
        assertArrives(FILTERING, ABOVE, through, through, through, sheets);
    }

    @Test
    void transmit_givenRememberedBlocker_asksItFirst() {
        SceneObject[] objects = {opaque(disc(20)), opaque(disc(30)), opaque(disc(2))};
        for (Shader shader : new Shader[] {BLOCKING, FILTERING}) {
            Shadow remembering = new Shadow(true, objects);
            assertThat(remembering.arrives(shader, ABOVE)).isEqualTo(Color.BLACK);
            long before = remembering.ray.tests();
            assertThat(remembering.arrives(shader, ABOVE)).isEqualTo(Color.BLACK);
            assertThat(remembering.ray.tests() - before).isEqualTo(1);

            remembering.ray.forgetBlockers();
            before = remembering.ray.tests();
            remembering.arrives(shader, ABOVE);
            assertThat(remembering.ray.tests() - before).isGreaterThan(1);
        }
    }

    @Test
    void transmit_givenListOrder_asksEachObjectOnce() {
        // The floor, two blocks whose both surfaces are crossed, and a sheet: four tests whatever is hit.
        SceneObject[] objects = {
            clear(slab(1, 2), Color.WHITE, Medium.VACUUM),
            clear(slab(3, 4), Color.WHITE, Medium.VACUUM),
            clear(disc(5), Color.WHITE, Medium.VACUUM)
        };
        Shadow listed = new Shadow(false, objects);
        listed.arrives(FILTERING, ABOVE);
        assertThat(listed.ray.tests()).isEqualTo(3 + floorTests());
        // An opaque object that comes after a transparent one in the list still ends the ray where its turn is.
        Shadow stopped = new Shadow(false, objects[0], opaque(disc(3)), objects[2]);
        stopped.arrives(FILTERING, ABOVE);
        assertThat(stopped.ray.tests()).isEqualTo(2 + floorTests());
    }

    /** The tests that the floor, which the ray leaves, takes. */
    private static long floorTests() {
        Shadow bare = new Shadow(false);
        bare.arrives(FILTERING, ABOVE);
        return bare.ray.tests();
    }

    private static void assertArrives(
            Shader shader, Vector3 light, double red, double green, double blue, SceneObject... objects) {
        Color arrives = arrives(shader, light, objects);
        assertThat(arrives.red()).isCloseTo(red, within(1e-14));
        assertThat(arrives.green()).isCloseTo(green, within(1e-14));
        assertThat(arrives.blue()).isCloseTo(blue, within(1e-14));
    }

    private static Color arrives(Shader shader, Vector3 light, SceneObject... objects) {
        return new Shadow(false, objects).arrives(shader, light);
    }

    private static final class Shadow {
        final SceneIndex index;
        final ShadowRay ray;

        Shadow(boolean remembersBlockers, SceneObject... above) {
            List<SceneObject> objects = new ArrayList<>();
            objects.add(opaque(new Plane(Vector3.ZERO, Vector3.UNIT_Y)));
            objects.addAll(Arrays.asList(above));
            index = SceneIndex.of(objects, !remembersBlockers);
            ray = new ShadowRay(index, 1, remembersBlockers);
        }

        Color arrives(Shader shader, Vector3 light) {
            LightSample sample = new LightSample();
            new PointLight(light, Color.WHITE).sample(0, 0, 0, 0, 0, sample);
            Hit hit = new Hit();
            hit.setNormal(0, 1, 0);
            ray.aim(0, hit, 0, sample, MediumLocator.locate(index, Vector3.ZERO));
            Rgb transmittance = new Rgb();
            boolean any = shader.transmit(ray, transmittance);
            assertThat(any).isEqualTo(!transmittance.isBlack());
            return transmittance.toColor();
        }
    }

    private static Disc disc(double height) {
        return new Disc(new Vector3(0, height, 0), Vector3.UNIT_Y, 100);
    }

    private static Box slab(double from, double to) {
        return new Box(new Vector3(-100, from, -100), new Vector3(100, to, 100));
    }

    private static SceneObject opaque(Shape shape) {
        return new SceneObject("opaque", shape, Material.builder().build());
    }

    private static SceneObject clear(Shape shape, Color transparency, Medium medium) {
        return new SceneObject(
                "clear",
                shape,
                Material.builder().transparency(transparency).inside(medium).build());
    }
}
