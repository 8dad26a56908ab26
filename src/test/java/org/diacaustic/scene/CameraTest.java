package org.diacaustic.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.diacaustic.math.Ray;
import org.diacaustic.math.SampleStream;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CameraTest {
    private final Ray ray = new Ray();

    @Test
    void builder_givenBadArguments_isRefused() {
        Camera.Builder camera = Camera.builder();
        assertThatIllegalArgumentException().isThrownBy(() -> camera.fieldOfView(180));
        assertThatIllegalArgumentException().isThrownBy(() -> camera.fieldOfView(Double.NaN));
        assertThatIllegalArgumentException().isThrownBy(() -> camera.size(0, 1)).withMessageContaining("0 x 1");
        assertThatIllegalArgumentException().isThrownBy(() -> camera.lens(-1, 1));
        assertThatIllegalArgumentException().isThrownBy(() -> camera.lens(1, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> camera.build().withSize(1, 0));
    }

    @Test
    void build_givenViewWithoutDirection_isRefusedByName() {
        Camera.Builder nowhere = Camera.builder().from(Vector3.ZERO).to(Vector3.ZERO);
        assertThatIllegalArgumentException().isThrownBy(nowhere::build).withMessageContaining("'to'");
        Camera.Builder upAlongView =
                Camera.builder().from(new Vector3(0, 5, 0)).to(Vector3.ZERO).up(Vector3.UNIT_Y);
        assertThatIllegalArgumentException().isThrownBy(upAlongView::build).withMessageContaining("'up'");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Camera.builder().up(Vector3.ZERO).build())
                .withMessageContaining("'up'");
    }

    @ParameterizedTest
    @CsvSource({
        // Half the tangent of half a millionth of a degree, 100 of 100.5 pixels out.
        "1e-6, 201, 201, 0, 0, -8.683230109424524431e-9, 8.683230109424524431e-9, -0.9999999999999999246, 9e-16",
        // Nearly a half space: the middle row's last pixel looks almost sideways.
        "179.999, 201, 101, 200, 50, 0.9999999999902893678, 0, -4.406956361375800032e-6, 1e-10",
        "90, 2, 1, 1, 0, 0.7071067811865475244, 0, -0.7071067811865475244, 2e-16",
    })
    void aim_givenMiddleOfPixel_pointsThroughIt(
            double degrees, int width, int height, int column, int row, double x, double y, double z, double error) {
        Camera camera =
                Camera.builder().fieldOfView(degrees).size(width, height).build();
        camera.aim(column + 0.5, row + 0.5, 0, 0, ray);

        assertThat(ray.directionX).isCloseTo(x, within(error));
        assertThat(ray.directionY).isCloseTo(y, within(error));
        assertThat(ray.directionZ).isCloseTo(z, within(error));
    }

    @Test
    void aim_givenTurnedCamera_keepsUpUpAndRightRight() {
        // From +x towards the origin, right is −z.
        Camera camera = Camera.builder()
                .from(new Vector3(5, 0, 0))
                .to(Vector3.ZERO)
                .size(4, 4)
                .build();
        camera.aim(4, 0, 0, 0, ray);
        double tangent = StrictMath.tan(StrictMath.toRadians(20));
        assertThat(ray.directionY / -ray.directionX).isCloseTo(tangent, within(1e-15));
        assertThat(ray.directionZ / -ray.directionX).isCloseTo(-tangent, within(1e-15));
        assertThat(ray.originX).isEqualTo(5);
    }

    @ParameterizedTest
    @CsvSource({
        // Aperture d, focus f, depth z: the blur's diameter is d |f − z| / f at z, and f/z times that on the plane of
        // focus.
        "0.1, 5, 4, 0.02, 0.025",
        "0.1, 5, 5, 0, 0",
        "0.2, 1e9, 3, 0.1999999994, 66666666.46666667",
    })
    void aim_givenLens_blursByTheDistanceFromTheFocus(
            double aperture, double focus, double depth, double blurAtDepth, double blurOnFocus) {
        Camera camera = Camera.builder().lens(aperture / 2, focus).size(3, 3).build();
        // The edges of the lens, left and right: angles 0 and π at full radius.
        double[] at = new double[2];
        for (int edge = 0; edge < 2; edge++) {
            camera.aim(1.5, 1.5, 1, edge * 0.5, ray);
            at[edge] = ray.originX + ray.directionX / -ray.directionZ * depth;
        }
        double blur = Math.abs(at[0] - at[1]);
        assertThat(blur).isCloseTo(blurAtDepth, within(1e-12 * aperture));
        // Seen by the pinhole, a blur at a depth covers focus / depth times as much of the plane of focus.
        assertThat(blur * focus / depth).isCloseTo(blurOnFocus, within(1e-12 * Math.max(aperture, blurOnFocus)));
    }

    @Test
    void aim_givenLens_meetsOnAFlatPlaneOfFocus() {
        // All lens points see the same point of the plane z = −5 through one point of the picture, aside of the axis
        // too.
        Camera camera =
                Camera.builder().fieldOfView(80).lens(0.3, 5).size(10, 10).build();
        Camera pinhole = Camera.builder().fieldOfView(80).size(10, 10).build();
        pinhole.aim(9, 1, 0, 0, ray);
        double x = 5 * ray.directionX / -ray.directionZ;
        double y = 5 * ray.directionY / -ray.directionZ;
        SampleStream random = new SampleStream();
        random.start(1, 0, 0);
        for (int i = 0; i < 100; i++) {
            camera.aim(9, 1, random.nextDouble(), random.nextDouble(), ray);
            double t = (5 + ray.originZ) / -ray.directionZ;
            assertThat(ray.pointX(t)).isCloseTo(x, within(1e-14));
            assertThat(ray.pointY(t)).isCloseTo(y, within(1e-14));
            assertThat(Math.hypot(ray.originX, ray.originY)).isLessThanOrEqualTo(0.3);
        }
    }

    @Test
    void aim_givenLensOfRadiusZero_isThePinholeToTheBit() {
        Camera pinhole = Camera.builder().size(7, 5).build();
        Camera closed = Camera.builder().lens(0, 3).size(7, 5).build();
        Ray other = new Ray();
        for (double x = 0; x < 7; x += 0.7) {
            pinhole.aim(x, x / 2, 0.3, 0.4, ray);
            closed.aim(x, x / 2, 0.9, 0.1, other);
            assertThat(other.directionX).isEqualTo(ray.directionX);
            assertThat(other.directionY).isEqualTo(ray.directionY);
            assertThat(other.directionZ).isEqualTo(ray.directionZ);
            assertThat(other.originX).isEqualTo(ray.originX);
        }
    }

    @Test
    void withSize_givenAnotherSize_keepsTheVerticalView() {
        Camera camera = Camera.builder()
                .from(new Vector3(1, 2, 3))
                .to(new Vector3(4, 1, 0))
                .lens(0.1, 7)
                .size(10, 20)
                .build();
        Camera larger = camera.withSize(40, 40);
        Ray other = new Ray();
        camera.aim(5, 3, 0.5, 0.5, ray);
        larger.aim(20, 6, 0.5, 0.5, other);

        assertThat(larger.width()).isEqualTo(40);
        assertThat(other.originY).isEqualTo(ray.originY);
        assertThat(other.directionX).isCloseTo(ray.directionX, within(1e-15));
        assertThat(other.directionY).isCloseTo(ray.directionY, within(1e-15));
    }

    @Test
    void aim_givenAWidestView_keepsItsDigits() {
        // tan((180° − 1e-10°)/2) = 1/tan(0.5e-10°) of half a pixel of two, to the right.
        Camera camera = Camera.builder().fieldOfView(180 - 0x1p-33).size(2, 2).build();
        camera.aim(1.5, 1, 0, 0, ray);
        double half = 1 / Math.tan(Math.toRadians(0x1p-34));
        assertThat(-ray.directionX / ray.directionZ).isCloseTo(0.5 * half, within(4e-16 * half));
    }

    @Test
    void aim_givenFocusAtInfinity_sendsParallelRays() {
        Camera camera =
                Camera.builder().size(4, 4).lens(0.25, Double.POSITIVE_INFINITY).build();
        camera.aim(1, 3, 1, 0.3, ray);
        Vector3 fromRim = new Vector3(ray.directionX, ray.directionY, ray.directionZ);
        assertThat(new Vector3(ray.originX, ray.originY, ray.originZ).length()).isCloseTo(0.25, within(1e-16));
        camera.aim(1, 3, 0, 0, ray);
        assertThat(fromRim).isEqualTo(new Vector3(ray.directionX, ray.directionY, ray.directionZ));
    }
}
