package org.diacaustic.preprocess;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.diacaustic.light.Falloff;
import org.diacaustic.map.Footprint;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The control scene's claim [Thesis 5.3] for the mesh: light through a sheet that does not bend it is what straight shadow rays
 * bring, averaged over the footprint. There is no noise, so the mesh is held to the order of its method.
 */
class MeshControlTest {
    /** Half the side of a footprint; the sheet's light is 6 wide. */
    private static final double HALF = 0.08;

    private static final int PLACES = 200;

    private static final Vector3 HIGH = new Vector3(0.3, 12, -0.2);

    /** So low over the sheet that a cube around the lamp sees it through five faces. */
    private static final Vector3 LOW = new Vector3(0.3, 5, -0.2);

    /** Nodes and weights of Gauss' rule of 4 points on −1..1. */
    private static final double[] NODES = {
        -0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526
    };

    private static final double[] WEIGHTS = {
        0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538
    };

    private static final List<Falloff> FALLOFFS =
            List.of(new Falloff.None(), new Falloff.InverseSquare(), new Falloff.Polynomial(1, 0.05, 0.002));

    static Stream<Arguments> cases() {
        return cases("own-map", "planar", "cube", "adaptive");
    }

    /** One plane before the sheet would be mostly beside it. */
    static Stream<Arguments> casesOfLowLamp() {
        return cases("own-map", "cube");
    }

    private static Stream<Arguments> cases(String... preProcessors) {
        return Stream.of(preProcessors).flatMap(name -> FALLOFFS.stream().map(falloff -> Arguments.of(name, falloff)));
    }

    /** Straight light of a lamp of intensity 1 through a sheet that lets 0.9 through, where the sheet is in between. */
    private static double straight(double x, double z, Vector3 lamp, Falloff falloff) {
        double dx = lamp.x() - x;
        double dz = lamp.z() - z;
        double distance = Math.sqrt(dx * dx + lamp.y() * lamp.y() + dz * dz);
        return 0.9 * lamp.y() / distance * falloff.at(distance);
    }

    /** Where light through an edge of the sheet, of height 4 and half side 2, comes to the floor. */
    private static double edge(double side, double lamp, double height) {
        return lamp + (2 * side - lamp) * height / (height - 4);
    }

    /** The mean over a square, of which only a part may be lit. */
    private static double mean(double x, double z, Vector3 lamp, Falloff falloff) {
        double lowX = Math.max(x - HALF, edge(-1, lamp.x(), lamp.y()));
        double highX = Math.min(x + HALF, edge(1, lamp.x(), lamp.y()));
        double lowZ = Math.max(z - HALF, edge(-1, lamp.z(), lamp.y()));
        double highZ = Math.min(z + HALF, edge(1, lamp.z(), lamp.y()));
        if (lowX >= highX || lowZ >= highZ) {
            return 0;
        }
        double sum = 0;
        for (int i = 0; i < 16; i++) {
            double u = 0.5 + 0.5 * NODES[i / 4];
            double v = 0.5 + 0.5 * NODES[i % 4];
            double at = straight(lowX + u * (highX - lowX), lowZ + v * (highZ - lowZ), lamp, falloff);
            sum += 0.25 * WEIGHTS[i / 4] * WEIGHTS[i % 4] * at;
        }
        return sum * (highX - lowX) * (highZ - lowZ) / (4 * HALF * HALF);
    }

    /** The root mean square of relative errors at places away from the edges of the light. */
    private static double innerError(MeshLight light, Vector3 lamp, Falloff falloff) {
        SplittableRandom random = new SplittableRandom(5);
        double squares = 0;
        for (int i = 0; i < PLACES; i++) {
            double x = random.nextDouble(-2.7, 2.4);
            double z = random.nextDouble(-2.5, 2.6);
            double error = light.irradiance(square(x, z)) / mean(x, z, lamp, falloff) - 1;
            squares += error * error;
        }
        return Math.sqrt(squares / PLACES);
    }

    /** The same across all four edges, relative to the light inside of them. */
    private static double edgeError(MeshLight light, Vector3 lamp, Falloff falloff) {
        SplittableRandom random = new SplittableRandom(6);
        double squares = 0;
        for (int i = 0; i < PLACES; i++) {
            double u = random.nextDouble(-2.7, 2.4);
            double off = random.nextDouble(-HALF, HALF);
            double side = (i & 2) - 1;
            double x = (i & 1) == 0 ? u : edge(side, lamp.x(), lamp.y()) + off;
            double z = (i & 1) == 0 ? edge(side, lamp.z(), lamp.y()) + off : u;
            double inside = straight(x, z, lamp, falloff);
            double error = (light.irradiance(square(x, z)) - mean(x, z, lamp, falloff)) / inside;
            squares += error * error;
        }
        return Math.sqrt(squares / PLACES);
    }

    private static Footprint square(double x, double z) {
        return MeshLight.above(0, 0, x - HALF, z - HALF, x + HALF, z + HALF);
    }

    /**
     * Away from edges the error is that of cells, 1/N. So it is at the edges of a chart that ends where the sheet does; any
     * other one gives light up to the size of its smallest cells, and how small they are is left to a few samples.
     *
     * @param innerBound on the error times the rays
     * @param edgeBound on the error times the rays, or times their root
     */
    private static void assertStraight(
            String preProcessor, Vector3 lamp, Falloff falloff, double innerBound, double edgeBound) {
        Scene scene = Forward.sheetOverFloor(lamp, falloff);
        for (long rays = 1 << 14; rays <= 1 << 16; rays *= 4) {
            MeshLight light = MeshLight.of(scene, Settings.physical(), preProcessor, rays);
            assertThat(innerError(light, lamp, falloff)).isLessThan(innerBound / rays);
            double unit = preProcessor.equals("own-map") ? rays : Math.sqrt(rays);
            assertThat(edgeError(light, lamp, falloff)).isLessThan(edgeBound / unit);
        }
    }

    @ParameterizedTest(name = "{0}, {1}")
    @MethodSource("cases")
    void irradiance_givenSheetThatDoesNotBend_isThatOfStraightShadowRays(String preProcessor, Falloff falloff) {
        assertStraight(preProcessor, HIGH, falloff, 1.5, 2);
    }

    @ParameterizedTest(name = "{0}, {1}")
    @MethodSource("casesOfLowLamp")
    void irradiance_givenLampJustOverTheSheet_isThatOfStraightShadowRays(String preProcessor, Falloff falloff) {
        boolean endsWithTheSheet = preProcessor.equals("own-map");
        assertStraight(preProcessor, LOW, falloff, endsWithTheSheet ? 40 : 100, endsWithTheSheet ? 64 : 20);
    }
}
