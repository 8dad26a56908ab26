package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;

class PackedNormalTest {
    private final SurfacePoint out = new SurfacePoint();
    private final SplittableRandom random = new SplittableRandom(1);

    @Test
    void unpack_givenAnAxis_isExact() {
        for (int axis = 0; axis < 3; axis++) {
            for (int sign = -1; sign <= 1; sign += 2) {
                double[] n = new double[3];
                n[axis] = sign;
                PackedNormal.unpack(PackedNormal.of(n[0], n[1], n[2]), out);
                assertThat(new double[] {out.normalX + 0, out.normalY + 0, out.normalZ + 0})
                        .isEqualTo(n);
            }
        }
    }

    @Test
    void unpack_givenAnyDirection_isWithinItsStep() {
        double largest = 0;
        for (int i = 0; i < 100_000; i++) {
            Vector3 n = direction();
            PackedNormal.unpack(PackedNormal.of(n.x(), n.y(), n.z()), out);
            Vector3 back = new Vector3(out.normalX, out.normalY, out.normalZ);
            assertThat(back.length()).isCloseTo(1, within(1e-15));
            largest = Math.max(largest, n.minus(back).length());
        }
        assertThat(largest).isBetween(0x1p-17, 0x1p-13);
    }

    @Test
    void isWithin_givenTwoDirections_comparesTheirAngle() {
        int within = 0;
        double cosine = PhotonFilter.TWO_SIDED_NORMAL.cosine();
        for (int i = 0; i < 10_000; i++) {
            Vector3 n = direction();
            Vector3 u = direction();
            int packed = PackedNormal.of(3 * n.x(), 3 * n.y(), 3 * n.z());
            if (Math.abs(n.dot(u) - cosine) > 1e-4) {
                assertThat(PackedNormal.isWithin(packed, cosine, u.x(), u.y(), u.z()))
                        .isEqualTo(n.dot(u) > cosine);
                within += n.dot(u) > cosine ? 1 : 0;
            }
        }
        // A cap of 67.5° is (1 − cos 67.5°)/2 of the sphere: 0.309.
        assertThat(within).isBetween(2900, 3280);
    }

    private Vector3 direction() {
        double z = random.nextDouble(-1, 1);
        double angle = random.nextDouble(2 * Math.PI);
        double r = Math.sqrt(1 - z * z);
        return new Vector3(r * Math.cos(angle), r * Math.sin(angle), z);
    }
}
