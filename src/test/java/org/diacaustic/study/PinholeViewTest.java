package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.junit.jupiter.api.Test;

class PinholeViewTest {
    private static final Camera CAMERA = Camera.builder()
            .from(new Vector3(1, 2, 3))
            .to(new Vector3(-4, 0, 5))
            .up(new Vector3(0.2, 1, 0))
            .fieldOfView(70)
            .size(31, 17)
            .build();

    private final PinholeView view = new PinholeView(CAMERA);
    private final Ray ray = new Ray();

    @Test
    void constructor_givenALens_isRefused() {
        Camera lens = Camera.builder().lens(0.1, 2).build();
        assertThatThrownBy(() -> new PinholeView(lens))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("lens-radius of 0.1");
    }

    @Test
    void aim_givenPointsOnEyeRays_findsTheirPixelsAndAimsTheSameRays() {
        Random random = new Random(1);
        Ray eye = new Ray();
        for (int i = 0; i < 1000; i++) {
            double x = 31 * random.nextDouble();
            double y = 17 * random.nextDouble();
            double t = 0.1 + 20 * random.nextDouble();
            CAMERA.aim(x, y, 0, 0, eye);
            int pixel = view.aim(eye.pointX(t), eye.pointY(t), eye.pointZ(t), ray);
            assertThat(pixel).isEqualTo((int) y * 31 + (int) x);
            assertThat(ray.directionX).isCloseTo(eye.directionX, within(1e-13));
            assertThat(ray.directionY).isCloseTo(eye.directionY, within(1e-13));
            assertThat(ray.directionZ).isCloseTo(eye.directionZ, within(1e-13));
        }
    }

    @Test
    void aim_givenPointsOutsideThePicture_findsNone() {
        Ray eye = new Ray();
        for (double[] outside : new double[][] {{-0.01, 5}, {31.01, 5}, {5, -0.01}, {5, 17.01}}) {
            CAMERA.aim(outside[0], outside[1], 0, 0, eye);
            assertThat(view.aim(eye.pointX(3), eye.pointY(3), eye.pointZ(3), ray))
                    .isEqualTo(-1);
        }
        CAMERA.aim(15, 8, 0, 0, eye);
        assertThat(view.aim(eye.pointX(-3), eye.pointY(-3), eye.pointZ(-3), ray))
                .as("behind")
                .isEqualTo(-1);
        assertThat(view.aim(1, 2, 3, ray)).as("at the eye").isEqualTo(-1);
    }

    @Test
    void pixelsPerSteradian_givenSmallParts_isTheirSolidAngleInverted() {
        double step = 1e-3;
        for (double[] at : new double[][] {{15.5, 8.5}, {0, 0}, {31, 8}}) {
            Vector3 here = direction(at[0], at[1]);
            Vector3 across = direction(at[0] + step, at[1]).minus(here);
            Vector3 down = direction(at[0], at[1] + step).minus(here);
            double solidAngle = across.cross(down).length();
            CAMERA.aim(at[0], at[1], 0, 0, ray);
            assertThat(view.pixelsPerSteradian(ray) * solidAngle).isCloseTo(step * step, within(1e-3 * step * step));
        }
    }

    private static Vector3 direction(double x, double y) {
        Ray eye = new Ray();
        CAMERA.aim(x, y, 0, 0, eye);
        return new Vector3(eye.directionX, eye.directionY, eye.directionZ);
    }
}
