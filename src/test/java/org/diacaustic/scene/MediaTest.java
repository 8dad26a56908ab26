package org.diacaustic.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.math.Color;
import org.diacaustic.math.Dielectric;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.junit.jupiter.api.Test;

/** Which media a straight ray along +x finds, boundary by boundary. */
class MediaTest {
    private static final double GLASS = 1.5;
    private static final double WATER = 1.33;

    @Test
    void cross_givenWaterInGlass_meetsEachBoundaryBetweenTheTwo() {
        // Reflectances at normal incidence: air-glass 0.04, glass-water (0.17 / 2.83)² = 0.003608…; together they let
        // through 0.914960…, against 0.8156… had there been air between glass and water.
        Walk walk = walk(Vector3.ZERO, solid(box(1, 4), GLASS, 0), solid(box(2, 3), WATER, 0));

        assertThat(walk.indices()).containsExactly(1.0, GLASS, WATER, GLASS, 1.0);
        assertThat(walk.reflectances.get(1)).isCloseTo(0.0036084855598147029418, within(1e-13 * 0.0036));
        assertThat(walk.transmittance).isCloseTo(0.9149608397246109560954, within(1e-13));
        assertThat(walk.last.indexOfRefraction()).isEqualTo(1);
    }

    @Test
    void cross_givenAirGapBetweenWaterAndGlass_meetsTheAirToo() {
        Walk walk =
                walk(Vector3.ZERO, solid(box(1, 5), GLASS, 0), solid(box(2, 4), 1, 0), solid(box(2.5, 3.5), WATER, 0));

        assertThat(walk.indices()).containsExactly(1.0, GLASS, 1.0, WATER, 1.0, GLASS, 1.0);
        assertThat(walk.transmittance).isCloseTo(0.8156137010511881966187, within(1e-13));
    }

    @Test
    void cross_givenOverlap_leavesItToTheHigherPriority() {
        // Glass from 0 to 1 and water from 0.9999 to 3: with the glass first in rank, their boundary is at 1.
        for (boolean glassFirst : new boolean[] {true, false}) {
            SceneObject glass = solid(box(0, 1), GLASS, 2);
            SceneObject water = solid(box(0.9999, 3), WATER, 1);
            Walk walk =
                    glassFirst ? walk(new Vector3(-1, 0, 0), glass, water) : walk(new Vector3(-1, 0, 0), water, glass);

            assertThat(walk.boundaries).containsExactly(0.0, 1.0, 3.0);
            assertThat(walk.indices()).containsExactly(1.0, GLASS, WATER, 1.0);
            assertThat(walk.reflectances.get(1)).isCloseTo(0.0036084855598147061394, within(1e-14));
            assertThat(walk.last).isEqualTo(Medium.VACUUM);
        }
    }

    @Test
    void cross_givenOverlapOfEqualPriority_leavesItToTheOneEnteredLast() {
        Walk walk = walk(Vector3.ZERO, solid(box(1, 3), GLASS, 0), solid(box(2, 4), WATER, 0));
        assertThat(walk.boundaries).containsExactly(1.0, 2.0, 4.0);
        assertThat(walk.indices()).containsExactly(1.0, GLASS, WATER, 1.0);
    }

    @Test
    void cross_givenSpheresThatAllButTouch_keepsOrMergesWhatIsBetween() {
        // With a sliver of air between them there are four interfaces, and 0.96⁴ passes; where they overlap by as
        // little,
        // both are one piece of glass, and 0.96² does.
        Walk apart = walk(new Vector3(-7, 0, 0), ball(-1 - 0x1p-40), ball(1));
        assertThat(apart.boundaries).hasSize(4);
        assertThat(apart.transmittance).isCloseTo(0.84934656, within(1e-14));
        assertThat(apart.last).isEqualTo(Medium.VACUUM);

        Walk merged = walk(new Vector3(-7, 0, 0), ball(-1 + 0x1p-40), ball(1));
        assertThat(merged.transmittance).isCloseTo(0.9216, within(1e-14));
        assertThat(merged.last).isEqualTo(Medium.VACUUM);
    }

    @Test
    void lookAt_givenTouchingBoundariesInEitherOrder_endsInTheSameMedium() {
        SceneIndex scene = index(solid(box(0, 1), GLASS, 0), solid(box(1, 2), WATER, 0));
        MediumStack media = new MediumStack(scene);
        media.cross(0, true);
        // Into the second before out of the first.
        media.cross(1, true);
        media.lookAt(0, false);
        assertThat(media.isVisible()).isFalse();
        media.cross(0, false);
        assertThat(media.current().indexOfRefraction()).isEqualTo(WATER);
    }

    @Test
    void lookAt_givenExitWithoutEntry_believesTheRayWasInside() {
        SceneIndex scene = index(solid(box(0, 1), GLASS, 0));
        MediumStack media = new MediumStack(scene);
        media.lookAt(0, false);

        assertThat(media.near().indexOfRefraction()).isEqualTo(GLASS);
        assertThat(media.far().indexOfRefraction()).isEqualTo(1);
        assertThat(media.isVisible()).isTrue();
        media.cross(0, false);
        assertThat(media.current()).isEqualTo(Medium.VACUUM);
    }

    @Test
    void lookAt_givenSheet_believesItsSidesWhateverCameBefore() {
        SceneIndex scene = index(sheet(2, 1.2, WATER, 0));
        MediumStack media = new MediumStack(scene);
        media.setBase(Medium.of(7));
        media.lookAt(0, true);
        assertThat(media.near().indexOfRefraction()).isEqualTo(1.2);
        assertThat(media.far().indexOfRefraction()).isEqualTo(WATER);
        assertThat(media.isVisible()).isTrue();
        media.lookAt(0, false);
        assertThat(media.near().indexOfRefraction()).isEqualTo(WATER);
        media.cross(0, false);
        assertThat(media.current().indexOfRefraction()).isEqualTo(1.2);
    }

    @Test
    void lookAt_givenSheetWithinGlass_isInvisibleButChangesWhatIsAround() {
        // The sheet at 2 cuts through a block of glass; behind the block there is the water that the sheet declares.
        Walk walk = walk(Vector3.ZERO, solid(box(1, 3), GLASS, 0), sheet(2, 1, WATER, 0));
        assertThat(walk.boundaries).containsExactly(1.0, 3.0);
        assertThat(walk.indices()).containsExactly(1.0, GLASS, WATER);
    }

    @Test
    void lookAt_givenSheetOfHigherPriority_cutsTheGlass() {
        // Water of priority 1 fills what is behind the sheet, the glass there included.
        Walk walk = walk(Vector3.ZERO, solid(box(1, 3), GLASS, 0), sheet(2, 1, WATER, 1));
        assertThat(walk.boundaries).containsExactly(1.0, 2.0);
        assertThat(walk.indices()).containsExactly(1.0, GLASS, WATER);
    }

    @Test
    void copyFrom_givenManyMedia_copiesThemAll() {
        SceneObject[] shells = new SceneObject[20];
        for (int i = 0; i < 20; i++) {
            shells[i] = solid(new Sphere(Vector3.ZERO, 20 - i), 1 + 0.1 * i, 0);
        }
        SceneIndex scene = index(shells);
        MediumStack media = MediumLocator.locate(scene, new Vector3(0, 0.5, 0));
        MediumStack copy = new MediumStack(scene);
        copy.copyFrom(media);
        for (int i = 19; i >= 0; i--) {
            assertThat(copy.current().indexOfRefraction()).isEqualTo(1 + 0.1 * i);
            copy.cross(i, false);
        }
        assertThat(copy.current()).isEqualTo(Medium.VACUUM);
        assertThat(media.current().indexOfRefraction()).isEqualTo(1 + 0.1 * 19);
    }

    @Test
    void locate_givenPointInGlass_startsInGlass() {
        // The first interface is glass to air: 0.04, and total reflection from 41.81° on.
        Walk walk = walk(Vector3.ZERO, solid(new Sphere(Vector3.ZERO, 1), GLASS, 0));
        assertThat(walk.indices()).containsExactly(GLASS, 1.0);
        assertThat(walk.reflectances.get(0)).isCloseTo(0.04, within(1e-15));
    }

    @Test
    void locate_givenNestedObjects_isInTheInnermost() {
        SceneIndex scene = index(
                solid(new Sphere(Vector3.ZERO, 1), 1.1, 0),
                opaque(new Sphere(Vector3.ZERO, 2)),
                solid(new Sphere(Vector3.ZERO, 3), 1.3, 0));
        assertThat(indexAt(scene, Vector3.ZERO)).isEqualTo(1.1);
        assertThat(indexAt(scene, new Vector3(0, 1.5, 0))).isEqualTo(1.3);
        assertThat(indexAt(scene, new Vector3(0, 4, 0))).isEqualTo(1);
        MediumStack media = MediumLocator.locate(scene, Vector3.ZERO);
        media.cross(0, false);
        assertThat(media.current().indexOfRefraction()).isEqualTo(1.3);
    }

    @Test
    void locate_givenSheets_decidesByTheSideOfTheNearest() {
        SceneIndex scene = index(sheet(2, 1, WATER, 0), sheet(5, WATER, GLASS, 0));
        assertThat(indexAt(scene, new Vector3(0, 0.3, 0.2))).isEqualTo(1);
        assertThat(indexAt(scene, new Vector3(2.5, 0.3, 0.2))).isEqualTo(WATER);
        assertThat(indexAt(scene, new Vector3(4.5, 0.3, 0.2))).isEqualTo(WATER);
        assertThat(indexAt(scene, new Vector3(9, 0.3, 0.2))).isEqualTo(GLASS);
    }

    private static double indexAt(SceneIndex scene, Vector3 point) {
        return MediumLocator.locate(scene, point).current().indexOfRefraction();
    }

    /** Goes along +x and notes every boundary that separates something. */
    private static Walk walk(Vector3 from, SceneObject... objects) {
        SceneIndex scene = index(objects);
        MediumStack media = MediumLocator.locate(scene, from);
        Walk walk = new Walk();
        walk.crossed.add(media.current());
        Dielectric dielectric = new Dielectric();
        Ray ray = new Ray();
        Hit hit = new Hit();
        ray.set(from, Vector3.UNIT_X);
        for (int object = scene.nearest(ray, SceneIndex.NONE, 0); object != SceneIndex.NONE; ) {
            hit.take(ray);
            scene.object(object).shape().complete(ray, hit);
            boolean entering = hit.normalX < 0;
            media.lookAt(object, entering);
            if (media.isVisible()) {
                dielectric.evaluate(
                        1, media.near().indexOfRefraction(), media.far().indexOfRefraction());
                walk.boundaries.add(Math.rint(hit.x * 1e9) / 1e9);
                walk.reflectances.add(dielectric.reflectance);
                walk.transmittance *= dielectric.transmittance;
                walk.crossed.add(media.far());
            }
            media.cross(object, entering);
            ray.set(new Vector3(hit.x, hit.y, hit.z), Vector3.UNIT_X);
            ray.departureError = hit.pointError;
            object = scene.nearest(ray, object, hit.primitive);
        }
        walk.last = media.current();
        return walk;
    }

    private static final class Walk {
        final List<Medium> crossed = new ArrayList<>();
        final List<Double> boundaries = new ArrayList<>();
        final List<Double> reflectances = new ArrayList<>();
        double transmittance = 1;
        Medium last;

        List<Double> indices() {
            return crossed.stream().map(Medium::indexOfRefraction).toList();
        }
    }

    private static SceneIndex index(SceneObject... objects) {
        return SceneIndex.of(Arrays.asList(objects), false);
    }

    private static Box box(double from, double to) {
        return new Box(new Vector3(from, -1, -1), new Vector3(to, 1, 1));
    }

    private static SceneObject solid(Shape shape, double indexOfRefraction, int priority) {
        Material material = Material.builder()
                .transparency(Color.WHITE)
                .inside(new Medium(indexOfRefraction, Color.BLACK, priority))
                .build();
        return new SceneObject("solid", shape, material);
    }

    private static SceneObject ball(double x) {
        return solid(new Sphere(new Vector3(x, 0, 0), 1), GLASS, 0);
    }

    private static SceneObject opaque(Shape shape) {
        return new SceneObject("opaque", shape, Material.builder().build());
    }

    /** A square at x that faces −x: its inside is where x is larger. */
    private static SceneObject sheet(double x, double before, double behind, int priority) {
        Shape shape = ConvexPolygon.twoSided(
                new Vector3(x, -9, -9), new Vector3(x, -9, 9), new Vector3(x, 9, 9), new Vector3(x, 9, -9));
        Material material = Material.builder()
                .transparency(Color.WHITE)
                .outside(Medium.of(before))
                .inside(new Medium(behind, Color.BLACK, priority))
                .build();
        return new SceneObject("sheet", shape, material);
    }
}
