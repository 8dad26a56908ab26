package org.diacaustic.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.offset;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CellStoreTest {
    private final SurfacePoint a = new SurfacePoint();
    private final SurfacePoint b = new SurfacePoint();
    private final SurfacePoint c = new SurfacePoint();
    private final Rgb power = new Rgb();

    @Test
    void constructor_givenWhatMakesNoSense_throws() {
        assertThatThrownBy(() -> new CellStore(new Vector3(0, Double.NaN, 0), 1, 10))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new CellStore(Vector3.ZERO, 0, 10)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new CellStore(Vector3.ZERO, 1, -1)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new CellStore(Vector3.ZERO, 1, CellStore.LARGEST_CAPACITY + 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(String.valueOf(CellStore.LARGEST_CAPACITY));
    }

    @Test
    void append_givenSlices_keepsTheirCellsInOrder() {
        CellStore store = new CellStore(new Vector3(1e6, 0, -1e6), 0x1p-10, 10_000);
        int stored = 0;
        for (int size : new int[] {300, 0, 1, 255, 256, 257, 2000}) {
            CellSlice slice = store.slice();
            for (int i = 0; i < size; i++) {
                add(slice, stored++);
            }
            assertThat(slice.size()).isEqualTo(size);
            store.append(slice);
            assertThat(slice.size()).isZero();
        }
        assertThat(store.size()).isEqualTo(stored);
        assertThat(store.rejectedCount()).isZero();
        assertThat(store.bytes()).isBetween(68L * stored, 68L * (stored + 256));
        for (int i = 0; i < stored; i++) {
            CellChunk chunk = store.chunkOf(i);
            int place = i % CellChunk.SIZE;
            assertThat(chunk.vertices[3 * place]).isEqualTo(i + 0.1, offset(1e-9));
            assertThat(chunk.vertices[3 * place + 2]).isEqualTo(1e6);
            float[] numbers = Arrays.copyOfRange(chunk.numbers, 9 * place, 9 * place + 9);
            assertThat(numbers).containsExactly(0.5f, 0, 0, 0, 0, -0.25f, i, 2f * i, 0);
            assertThat(chunk.tags[2 * place + 1]).isEqualTo(2 * (i % 7) + (i % 2 == 0 ? 1 : 0));
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {-900, -150, 0, 150, 900})
    void addTriangle_givenAnyScale_keepsItsSize(int exponent) {
        double scale = Math.scalb(1.0, exponent);
        CellStore store = new CellStore(Vector3.ZERO, scale, 1, 10);
        CellSlice slice = store.slice();
        slice.addTriangle(
                TestCells.floor(0.5 * scale, 0),
                TestCells.floor(0.75 * scale, 0),
                TestCells.floor(0.5 * scale, 0.125 * scale),
                new Rgb().set(1, 1, 1));
        store.append(slice);
        Cell cell = new Cell();
        store.read(0, cell);
        assertThat(cell.vertices).containsExactly(0.5 * scale, 0, 0, 0.75 * scale, 0, 0, 0.5 * scale, 0.125 * scale, 0);
        CausticMesh mesh = CausticMesh.movedFrom(store, new Workers(1));
        // 1 W on an area of scale²/64.
        double irradiance = TestCells.density(mesh, TestCells.floor(0.55 * scale, 0.05 * scale));
        assertThat(exponent == 0 ? irradiance : 64).isEqualTo(64);
        assertThat(Math.abs(exponent) < 500 ? irradiance * scale * scale : 64).isEqualTo(64);
    }

    @Test
    void addPoint_givenAPoint_isATriangleOfThreeEqualVertices() {
        CellStore store = new CellStore(Vector3.ZERO, 1, 10);
        CellSlice slice = store.slice();
        set(3);
        slice.addPoint(a, power.set(1, 2, 3));
        store.append(slice);
        assertThat(Arrays.copyOf(store.chunkOf(0).numbers, 9)).containsExactly(0, 0, 0, 0, 0, 0, 1, 2, 3);
    }

    @Test
    void addTriangle_givenNumbersThatAreNone_leavesTheCellOutAndCountsIt() {
        CellStore store = new CellStore(Vector3.ZERO, 1, 1000);
        CellSlice slice = store.slice();
        double[] bad = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 1e300};
        int left = 0;
        for (double wrong : bad) {
            for (int what = 0; what < 7; what++) {
                set(1);
                switch (what) {
                    case 0 -> a.x = wrong;
                    case 1 -> b.y = wrong;
                    case 2 -> c.z = wrong;
                    case 3 -> c.normalY = wrong == 1e300 ? Double.NaN : wrong;
                    case 4 -> power.green = wrong;
                    case 5 -> power.blue = -Math.abs(wrong);
                    default -> a.z = wrong;
                }
                slice.addTriangle(a, b, c, power);
                left++;
                add(slice, 1);
            }
        }
        set(1);
        a.normalZ = -1;
        slice.addTriangle(a, b, c, power);
        assertThat(slice.rejectedCount()).isEqualTo(left + 1);
        assertThat(slice.size()).isEqualTo(left);
        store.append(slice);
        assertThat(store.rejectedCount()).isEqualTo(left + 1);
        assertThat(store.size()).isEqualTo(left);
    }

    @Test
    void append_givenMoreThanTheCapacity_throws() {
        CellStore store = new CellStore(Vector3.ZERO, 1, 1000);
        CellSlice full = store.slice();
        CellSlice more = store.slice();
        for (int i = 0; i < 1000; i++) {
            add(full, i);
        }
        add(more, 0);
        store.append(full);
        assertThatThrownBy(() -> store.append(more))
                .isInstanceOf(PhotonCapacityException.class)
                .hasMessage("more cells than the store's capacity of 1000");
    }

    @Test
    void addTriangle_givenFarMoreThanTheCapacity_throwsBeforeTheSliceEnds() {
        CellSlice slice = new CellStore(Vector3.ZERO, 1, 1000).slice();
        assertThatThrownBy(() -> {
                    for (int i = 0; i < 2000; i++) {
                        add(slice, i);
                    }
                })
                .isInstanceOf(PhotonCapacityException.class);
        assertThat(slice.size()).isBetween(1000, 1024);
    }

    @Test
    void addTriangle_givenChunksToUseAgain_allocatesNothing() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        CellStore store = new CellStore(Vector3.ZERO, 1, 1_000_000);
        CellSlice slice = store.slice();
        CellSlice other = store.slice();
        for (int i = 0; i < 20_000; i++) {
            add(other, i);
        }
        other.release();
        long least = Long.MAX_VALUE;
        for (int pass = 0; pass < 12; pass++) {
            long before = threads.getCurrentThreadAllocatedBytes();
            for (int i = 0; i < 20_000; i++) {
                add(slice, i);
            }
            slice.release();
            least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
        }
        assertThat(least).isZero();
    }

    private void add(CellSlice slice, int i) {
        set(i);
        slice.addTriangle(a, b, c, power);
    }

    /** A triangle at (10^6 + i + 0.1, 0, 0): half a unit along x, a quarter down z. */
    private void set(int i) {
        set(a, i);
        set(b, i);
        set(c, i);
        c.normalZ = 0;
        b.x += 0.5;
        c.z -= 0.25;
        power.set(0x1p-10 * i, 0x1p-9 * i, 0);
    }

    private static void set(SurfacePoint point, int i) {
        point.x = 1e6 + i + 0.1;
        point.y = 0;
        point.z = 0;
        point.normalX = 0;
        point.normalY = 0;
        point.normalZ = 1;
        point.object = i % 7;
        point.front = i % 2 == 0;
    }
}
