package org.diacaustic.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.function.ToDoubleFunction;
import org.diacaustic.image.LinearImage;
import org.diacaustic.math.SampleStream;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Hit;
import org.junit.jupiter.api.Test;

class BumpMapTest {
    private static final double FOREVER = Double.POSITIVE_INFINITY;

    @Test
    void constructor_givenBadArguments_isRefused() {
        assertThatIllegalArgumentException().isThrownBy(() -> new Wave(Vector3.UNIT_X, 0, 1, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new Wave(Vector3.ZERO, 1, 1, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> Wave.ofLength(Vector3.UNIT_X, 0, 1, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new Wave(Vector3.UNIT_X, 1, Double.NaN, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new Ripple(Vector3.ZERO, -1, 1, 0, 1));
        assertThatIllegalArgumentException().isThrownBy(() -> new Ripple(Vector3.ZERO, 1, 1, 0, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new ImageBump(new LinearImage(1, 1), FOREVER, 1, 1));
        assertThatIllegalArgumentException().isThrownBy(() -> new ImageBump(new LinearImage(1, 1), 1, 0, 1));
    }

    @Test
    void tilt_givenWave_isTheExactNormal() {
        // h = 0.05 sin 10x at x = 0.3: slope 0.5 cos 3, normal (−slope, 1) / √(1 + slope²).
        Hit gentle = tilted(new Wave(Vector3.UNIT_X, 10, 0.05, 0), 0.3, 0, 0);
        assertThat(gentle.shadingX).isCloseTo(0.4436224531428568845, within(2.8e-14));
        assertThat(gentle.shadingY).isCloseTo(0.8962137686219252389, within(2.8e-14));
        assertThat(gentle.shadingZ).isZero();
        // h = sin 1000x at x = 0.25: far too short and steep for a fixed difference.
        Hit steep = tilted(new Wave(Vector3.UNIT_X, 1000, 1, 0), 0.25, 0, 0);
        assertThat(steep.shadingX).isCloseTo(-0.9999913906084320424, within(1.8e-12));
        assertThat(steep.shadingY).isCloseTo(0.0041495432295967183, within(1.8e-12));
        // The surface itself is not moved.
        assertThat(steep.normalY).isEqualTo(1);
    }

    @Test
    void tilt_givenNoSlope_changesNoBit() {
        // A wave without height, on a normal whose length is not 1 to the last bit.
        Vector3 normal = new Vector3(0.1, 1, 0.3).normalized();
        Hit hit = new Hit();
        hit.setNormal(normal.x(), normal.y(), normal.z());
        Material.builder().bump(new Wave(Vector3.UNIT_X, 1, 0, 0)).build().evaluate(hit, new Surface());
        assertThat(hit.shadingX).isEqualTo(normal.x());
        assertThat(hit.shadingY).isEqualTo(normal.y());
        assertThat(hit.shadingZ).isEqualTo(normal.z());
    }

    @Test
    void addGradient_givenWaves_isTheSlopeOfTheirHeight() {
        Vector3 direction = new Vector3(1, 0.5, -2).normalized();
        assertSlope(new Wave(direction, 3, 0.2, 0.7), p -> 0.2 * StrictMath.sin(3 * p.dot(direction) + 0.7));
        assertSlope(
                Wave.ofLength(direction, 0.8, 0.1, 0), p -> 0.1 * StrictMath.sin(2 * Math.PI * p.dot(direction) / 0.8));
    }

    @Test
    void addGradient_givenRipples_isTheSlopeOfTheirHeight() {
        Vector3 centre = new Vector3(0.3, -0.1, 2);
        for (double reach : new double[] {0.5, FOREVER}) {
            assertSlope(new Ripple(centre, 4, 0.3, 0.2, reach), p -> {
                double r = p.minus(centre).length();
                return 0.3 * StrictMath.exp(-r / reach) * StrictMath.sin(4 * r + 0.2);
            });
        }
    }

    @Test
    void tilt_givenCentreOfRipple_isFlat() {
        Hit hit = tilted(new Ripple(Vector3.ZERO, 4, 0.3, 0, 1), 0, 0, 0);
        assertThat(hit.shadingY).isEqualTo(1);
    }

    @Test
    void addGradient_givenRampOfGrey_risesAcrossTheTangents() {
        // Brightness k/8 at texel k of 8 is 1 per map width between texels: with a height of 0.5 on a map 4 wide, the
        // slope is 0.5 / 4 along x. The map's v runs askew, at 45°, which must not matter.
        LinearImage ramp = new LinearImage(8, 2);
        for (int x = 0; x < 8; x++) {
            for (int y = 0; y < 2; y++) {
                ramp.set(x, y, x / 8.0, x / 8.0, x / 8.0);
            }
        }
        Hit hit = flatHit(0, 0, 0);
        hit.setMap(0.45, 0.5);
        hit.setTangents(4, 0, 0, 3, 0, 3);
        BumpMap.Gradient gradient = new BumpMap.Gradient();
        new ImageBump(ramp, 0.5, 1, 1).addGradient(hit, gradient);

        // Along v = (3, 0, 3) nothing changes, so the gradient is (1, 0, −1) / 8.
        assertThat(gradient.x).isCloseTo(0.125, within(1e-15));
        assertThat(gradient.y).isZero();
        assertThat(gradient.z).isCloseTo(-0.125, within(1e-15));
    }

    @Test
    void addGradient_givenMapWithoutTangents_isFlat() {
        LinearImage noise = new LinearImage(2, 1);
        noise.set(1, 0, 1, 1, 1);
        BumpMap.Gradient gradient = new BumpMap.Gradient();
        new ImageBump(noise, 1, 1, 1).addGradient(flatHit(0, 0, 0), gradient);

        assertThat(gradient.x).isZero();
        assertThat(gradient.z).isZero();
    }

    @Test
    void evaluate_givenSeveralBumps_addsThem() {
        Wave first = new Wave(Vector3.UNIT_X, 3, 0.2, 0.1);
        Wave second = new Wave(Vector3.UNIT_Z, 5, 0.1, 0);
        Hit hit = flatHit(0.4, 0, 0.7);
        Material.builder().bump(first).bump(second).build().evaluate(hit, new Surface());

        double slopeX = 0.6 * StrictMath.cos(1.3);
        double slopeZ = 0.5 * StrictMath.cos(3.5);
        assertThat(hit.shadingX / hit.shadingY).isCloseTo(-slopeX, within(1e-14));
        assertThat(hit.shadingZ / hit.shadingY).isCloseTo(-slopeZ, within(1e-14));
    }

    @Test
    void tilt_givenSceneScaledByPowersOfTwo_isTheSameToTheBit() {
        for (double k : new double[] {0x1p20, 0x1p-20}) {
            Vector3 centre = new Vector3(0.1, 0, 0.2);
            assertSameNormal(
                    tilted(new Wave(new Vector3(1, 0, 3), 7, 0.3, 1), 0.37, 0, 0.81),
                    tilted(new Wave(new Vector3(1, 0, 3), 7 / k, 0.3 * k, 1), 0.37 * k, 0, 0.81 * k));
            assertSameNormal(
                    tilted(new Ripple(centre, 7, 0.3, 1, 0.9), 0.37, 0, 0.81),
                    tilted(new Ripple(centre.times(k), 7 / k, 0.3 * k, 1, 0.9 * k), 0.37 * k, 0, 0.81 * k));
        }
    }

    private static void assertSlope(BumpMap bump, ToDoubleFunction<Vector3> height) {
        SampleStream random = new SampleStream();
        random.start(1, 0, 0);
        double h = 1e-5;
        for (int i = 0; i < 100; i++) {
            Vector3 p = new Vector3(random.nextDouble(), random.nextDouble(), random.nextDouble());
            BumpMap.Gradient gradient = new BumpMap.Gradient();
            bump.addGradient(flatHit(p.x(), p.y(), p.z()), gradient);
            // The central difference is off by h²/6 of the third derivative, below 1e-8 here.
            assertThat(gradient.x).isCloseTo(difference(height, p, new Vector3(h, 0, 0)), within(1e-8));
            assertThat(gradient.y).isCloseTo(difference(height, p, new Vector3(0, h, 0)), within(1e-8));
            assertThat(gradient.z).isCloseTo(difference(height, p, new Vector3(0, 0, h)), within(1e-8));
        }
    }

    private static double difference(ToDoubleFunction<Vector3> height, Vector3 p, Vector3 step) {
        return (height.applyAsDouble(p.plus(step)) - height.applyAsDouble(p.minus(step))) / (2 * step.length());
    }

    private static void assertSameNormal(Hit hit, Hit scaled) {
        assertThat(scaled.shadingX).isEqualTo(hit.shadingX);
        assertThat(scaled.shadingY).isEqualTo(hit.shadingY);
        assertThat(scaled.shadingZ).isEqualTo(hit.shadingZ);
    }

    private static Hit tilted(BumpMap bump, double x, double y, double z) {
        Hit hit = flatHit(x, y, z);
        Material.builder().bump(bump).build().evaluate(hit, new Surface());
        return hit;
    }

    private static Hit flatHit(double x, double y, double z) {
        Hit hit = new Hit();
        hit.setPoint(x, y, z, 0);
        hit.setNormal(0, 1, 0);
        return hit;
    }
}
