package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;

class PhotonStoreTest {
    private final SurfacePoint at = new SurfacePoint();
    private final Rgb power = new Rgb();

    @Test
    void constructor_givenWhatMakesNoSense_throws() {
        assertThatThrownBy(() -> new PhotonStore(new Vector3(0, Double.NaN, 0), 1, 10))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new PhotonStore(Vector3.ZERO, 0, 10)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new PhotonStore(Vector3.ZERO, 1, -1)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void append_givenSlices_keepsTheirPhotonsInOrder() {
        PhotonStore store = new PhotonStore(new Vector3(1e6, 0, -1e6), 0x1p-10, 10_000);
        int stored = 0;
        for (int size : new int[] {300, 0, 1, 255, 256, 257, 2000}) {
            PhotonSlice slice = store.slice();
            for (int i = 0; i < size; i++) {
                add(slice, stored++);
            }
            assertThat(slice.size()).isEqualTo(size);
            store.append(slice);
            assertThat(slice.size()).isZero();
        }
        assertThat(store.size()).isEqualTo(stored);
        assertThat(store.rejectedCount()).isZero();
        for (int i = 0; i < stored; i++) {
            store.position(i, at);
            store.power(i, power);
            assertThat(at.x).isEqualTo(1e6 + i);
            assertThat(at.y).isEqualTo(-i);
            assertThat(at.z).isEqualTo(-1e6 + 0.5 * i);
            assertThat(at.normalZ).isCloseTo(0.8, within(0x1p-14));
            assertThat(at.normalY).isCloseTo(-0.6, within(0x1p-14));
            assertThat(at.object).isEqualTo(i % 7);
            assertThat(at.front).isEqualTo(i % 2 == 0);
            assertThat(power.red).isEqualTo(0x1p-10 * i);
            assertThat(power.green).isEqualTo(0x1p-11 * i);
            assertThat(power.blue).isEqualTo(0x1p-12 * i);
        }
    }

    @Test
    void add_givenNumbersThatAreNone_leavesThePhotonOutAndCountsIt() {
        PhotonStore store = new PhotonStore(Vector3.ZERO, 1, 1000);
        PhotonSlice slice = store.slice();
        double[] bad = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 1e300};
        for (int i = 0; i < 100; i++) {
            add(slice, i);
            double wrong = bad[i % bad.length];
            set(i);
            switch (i / bad.length % 5) {
                case 0 -> at.x = wrong;
                case 1 -> at.z = wrong;
                case 2 -> at.normalY = wrong == 1e300 ? Double.NaN : wrong;
                case 3 -> power.green = wrong;
                default -> power.blue = -Math.abs(wrong);
            }
            slice.add(at, power);
        }
        set(0);
        at.normalY = 0;
        at.normalZ = 0;
        slice.add(at, power);
        assertThat(slice.rejectedCount()).isEqualTo(101);
        store.append(slice);
        assertThat(store.rejectedCount()).isEqualTo(101);
        assertThat(store.size()).isEqualTo(100);
        for (int i = 0; i < 100; i++) {
            store.position(i, at);
            assertThat(at.x).isEqualTo(1e6 + i);
        }
    }

    @Test
    void add_givenAPowerTooSmallForItsUnit_storesNone() {
        PhotonStore store = new PhotonStore(Vector3.ZERO, 1, 10);
        PhotonSlice slice = store.slice();
        set(1);
        power.set(1e-60, 1, 0);
        slice.add(at, power);
        store.append(slice);
        store.power(0, power);
        assertThat(power.red).isZero();
        assertThat(power.green).isEqualTo(1);
    }

    @Test
    void append_givenMoreThanTheCapacity_throws() {
        PhotonStore store = new PhotonStore(Vector3.ZERO, 1, 1000);
        PhotonSlice full = store.slice();
        PhotonSlice more = store.slice();
        for (int i = 0; i < 1000; i++) {
            add(full, i);
        }
        add(more, 0);
        store.append(full);
        assertThatThrownBy(() -> store.append(more))
                .isInstanceOf(PhotonCapacityException.class)
                .hasMessageContaining("1000");
        assertThat(store.size()).isEqualTo(1000);
    }

    @Test
    void add_givenFarMoreThanTheCapacity_throwsBeforeTheSliceEnds() {
        PhotonStore store = new PhotonStore(Vector3.ZERO, 1, 1000);
        PhotonSlice slice = store.slice();
        assertThatThrownBy(() -> {
                    for (int i = 0; i < 2000; i++) {
                        add(slice, i);
                    }
                })
                .isInstanceOf(PhotonCapacityException.class);
        assertThat(slice.size()).isBetween(1000, 1024);
    }

    @Test
    void add_givenChunksToUseAgain_allocatesNothing() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        PhotonStore store = new PhotonStore(Vector3.ZERO, 1, 100_000);
        PhotonSlice slice = store.slice();
        long least = Long.MAX_VALUE;
        for (int pass = 0; pass < 12; pass++) {
            long before = threads.getCurrentThreadAllocatedBytes();
            for (int i = 0; i < 20_000; i++) {
                add(slice, i);
            }
            store.append(slice);
            store.clear();
            least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
        }
        assertThat(store.size()).isZero();
        assertThat(least).isZero();
    }

    private void add(PhotonSlice slice, int i) {
        set(i);
        slice.add(at, power);
    }

    private void set(int i) {
        at.x = 1e6 + i;
        at.y = -i;
        at.z = -1e6 + 0.5 * i;
        at.normalX = 0;
        at.normalY = -0.6;
        at.normalZ = 0.8;
        at.object = i % 7;
        at.front = i % 2 == 0;
        power.set(0x1p-10 * i, 0x1p-11 * i, 0x1p-12 * i);
    }
}
