package org.diacaustic.preprocess;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.diacaustic.light.DirectionalLight;
import org.diacaustic.light.Falloff;
import org.diacaustic.light.Light;
import org.diacaustic.map.Footprint;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Frustum;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Light stays on the side of things that it shines on, to the last bit. */
class MeshLeakTest {
    private static final int RAYS = 20_000;
    private static final Settings PHYSICAL = Settings.physical();
    private static final Vector3 UP = Vector3.UNIT_Y;
    private static final Vector3 X = Vector3.UNIT_X;

    static List<String> preProcessors() {
        return MeshPassTest.preProcessors();
    }

    private static Light lamp() {
        return Forward.lamp(v(0, 7, 0), new Falloff.InverseSquare());
    }

    /** A glass ball about a place, over things. */
    private static Scene glassOver(Vector3 at, Shape... things) {
        Scene.Builder scene = Scene.builder().camera(Forward.camera()).light(lamp());
        for (Shape thing : things) {
            scene.object("thing " + thing.bounds(), thing, Forward.MATT);
        }
        return scene.object("glass", new Sphere(at, 1), Forward.clear(1.5, 1)).build();
    }

    /** A ball of glass throws light onto a wall of paper, and beside it onto the floor; the wall is as dark behind as can be. */
    @ParameterizedTest
    @MethodSource("preProcessors")
    void irradiance_givenThinWall_isZeroBehindIt(String preProcessor) {
        Scene scene = glassOver(
                v(0, 2, 0),
                Forward.square(0, 9),
                ConvexPolygon.twoSided(v(1.5, 0, -4), v(1.5, 5, -4), v(1.5, 5, 4), v(1.5, 0, 4)));
        MeshLight light = MeshLight.of(scene, PHYSICAL, preProcessor, RAYS);
        double lit = 0;
        for (boolean front : new boolean[] {true, false}) {
            lit += light.irradiance(wall(front, X.negated(), 0, -4, 5, 4));
            assertThat(light.irradiance(wall(front, X, 0, -4, 5, 4))).isZero();
        }
        assertThat(lit).isPositive();
        // Light that would have come to the floor behind stands on the wall.
        assertThat(light.irradiance(MeshLight.above(0, 0, 1.5, -0.2, 1.7, 0.2))).isZero();
        assertThat(light.irradiance(MeshLight.above(0, 0, 1.3, -0.2, 1.5, 0.2))).isPositive();
    }

    private static Footprint wall(boolean front, Vector3 normal, double lowY, double lowZ, double highY, double highZ) {
        return MeshLight.polygon(
                MeshLight.on(1, front, normal),
                normal.negated(),
                v(1.5, lowY, lowZ),
                v(1.5, highY, lowZ),
                v(1.5, highY, highZ),
                v(1.5, lowY, highZ));
    }

    /** Of a slab only 1e-6 thick both faces are outside: they differ by their normals, and no distance tells them apart. */
    @ParameterizedTest
    @MethodSource("preProcessors")
    void irradiance_givenSlabOneMillionthThick_isZeroBelowIt(String preProcessor) {
        Scene scene = glassOver(v(0, 2, 0), Forward.square(-1, 9), new Box(v(-5, -1e-6, -5), v(5, 0, 5)));
        MeshLight light = MeshLight.of(scene, PHYSICAL, preProcessor, RAYS);
        assertThat(light.irradiance(MeshLight.above(1, 0, -5, -5, 5, 5))).isPositive();
        Footprint below = MeshLight.polygon(
                MeshLight.on(1, true, UP.negated()),
                UP,
                v(-5, -1e-6, -5),
                v(5, -1e-6, -5),
                v(5, -1e-6, 5),
                v(-5, -1e-6, 5));
        assertThat(light.irradiance(below)).isZero();
        below.reach(Double.POSITIVE_INFINITY);
        assertThat(light.irradiance(below)).isZero();
        // And on the floor under it.
        assertThat(light.irradiance(MeshLight.above(0, -1, -4, -4, 4, 4))).isZero();
    }

    /** A floor that hides another: nothing comes to what lies in its shade, however near its border. */
    @ParameterizedTest
    @MethodSource("preProcessors")
    void irradiance_givenFloorUnderAFloor_isZeroInItsShade(String preProcessor) {
        Scene scene = glassOver(v(0, 2, 0), new Plane(v(0, -0.5, 0), UP), Forward.square(0, 0.4));
        MeshLight light = MeshLight.of(scene, PHYSICAL, preProcessor, RAYS);
        assertThat(light.irradiance(MeshLight.above(1, 0, -0.4, -0.4, 0.4, 0.4)))
                .isPositive();
        assertThat(light.irradiance(MeshLight.above(0, -0.5, -0.1, -0.1, 0.1, 0.1)))
                .isZero();
        assertThat(light.irradiance(MeshLight.above(0, -0.5, -5, -5, 5, 5))).isPositive();
    }

    /**
     * The sun shines at a slope of 3:4 through a clear pane onto a cube: a side of it gets 0.9 · 0.6, its top 0.9 · 0.8, up to
     * the edge between them, which may be 2e-3 off; its other sides get nothing at all.
     */
    @Test
    void irradiance_givenSunOnACube_endsAtItsEdges() {
        Scene scene = Scene.builder()
                .camera(Forward.camera())
                .light(new DirectionalLight(v(-0.6, -0.8, 0), Color.WHITE, 0))
                .object("floor", new Plane(Vector3.ZERO, UP), Forward.MATT)
                .object("cube", new Box(v(-1, 0, -1), v(1, 2, 1)), Forward.MATT)
                .object("pane", Forward.square(4, 6), Forward.clear(1, 0.9))
                .build();
        MeshLight light = MeshLight.of(scene, PHYSICAL, "planar", 1 << 16);
        for (double edge : new double[] {0.01, 0.1, 1}) {
            assertThat(light.irradiance(MeshLight.above(1, 2, 1 - edge, -0.9, 1, 0.9)))
                    .isCloseTo(0.72, within(2e-3 / edge));
            assertThat(light.irradiance(
                            side(X, v(1, 2 - edge, -0.9), v(1, 2, -0.9), v(1, 2, 0.9), v(1, 2 - edge, 0.9))))
                    .isCloseTo(0.54, within(2e-3 / edge));
        }
        assertThat(light.irradiance(side(X.negated(), v(-1, 0, -1), v(-1, 2, -1), v(-1, 2, 1), v(-1, 0, 1))))
                .isZero();
        for (int z = -1; z <= 1; z += 2) {
            assertThat(light.irradiance(side(v(0, 0, z), v(-1, 0, z), v(1, 0, z), v(1, 2, z), v(-1, 2, z))))
                    .isZero();
        }
        assertThat(light.irradiance(side(UP.negated(), v(-1, 0, -1), v(1, 0, -1), v(1, 0, 1), v(-1, 0, 1))))
                .isZero();
        assertThat(light.irradiance(MeshLight.above(0, 0, -0.99, -0.99, 0.99, 0.99)))
                .isZero();
    }

    private static Footprint side(Vector3 normal, Vector3... corners) {
        return MeshLight.polygon(MeshLight.on(1, true, normal), normal.negated(), corners);
    }

    /** Light falls from the ball into an open pipe that is wider: what does not can never come to the pipe's outside. */
    @ParameterizedTest
    @ValueSource(doubles = {1.05, 1.3})
    void irradiance_givenOpenPipe_isZeroOnItsOutside(double radius) {
        Scene scene = glassOver(
                v(0, 2, 0), new Plane(v(0, -3, 0), UP), Frustum.cylinder(v(0, -3, 0), v(0, 1, 0), radius, false));
        MeshLight light = MeshLight.of(scene, PHYSICAL, "own-map", RAYS);
        double inside = 0;
        double outside = 0;
        for (boolean front : new boolean[] {true, false}) {
            inside += light.irradiance(pipe(front, X.negated(), radius));
            outside += light.irradiance(pipe(front, X, radius));
        }
        assertThat(inside).isPositive();
        assertThat(outside).isZero();
    }

    /** Where the pipe is nearest to x = ∞, from inside or outside. */
    private static Footprint pipe(boolean front, Vector3 normal, double radius) {
        Footprint footprint = MeshLight.polygon(
                MeshLight.on(1, front, normal),
                normal.negated(),
                v(radius, -2.9, -0.2),
                v(radius, 0.9, -0.2),
                v(radius, 0.9, 0.2),
                v(radius, -2.9, 0.2));
        footprint.reach(0.1);
        return footprint;
    }

    private static Vector3 v(double x, double y, double z) {
        return new Vector3(x, y, z);
    }
}
