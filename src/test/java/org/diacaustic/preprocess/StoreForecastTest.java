package org.diacaustic.preprocess;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.BitSet;
import java.util.function.IntToLongFunction;
import org.diacaustic.map.PhotonCapacityException;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.parallel.Workers;
import org.junit.jupiter.api.Test;

class StoreForecastTest {
    private static void forecast(int capacity, long before, int tasks, IntToLongFunction trial) {
        StoreForecast.requireRoom("photons", capacity, before, tasks, new Workers(2), () -> trial);
    }

    @Test
    void requireRoom_givenTwiceAsMuchAsThereIsRoomFor_saysHowMuchIsExpected() {
        // 50 + 1000 tasks of 10 each.
        assertThatThrownBy(() -> forecast(5000, 50, 1000, task -> 10))
                .isInstanceOf(PhotonCapacityException.class)
                .hasMessage("about 1.0e+04 photons are to be expected, but there is room for 5000");
        assertThatCode(() -> forecast(5026, 50, 1000, task -> 10)).doesNotThrowAnyException();
        assertThatCode(() -> forecast(0, 0, 0, task -> 10)).doesNotThrowAnyException();
    }

    /** A million rows of a thousand tasks, of which the middle half of each stores: half of all, wherever rows begin. */
    @Test
    void requireRoom_givenRows_triesAllPartsOfThem() {
        int row = 1000;
        IntToLongFunction middle = task -> task % row >= row / 4 && task % row < 3 * row / 4 ? 1 : 0;
        assertThatThrownBy(() -> forecast(150_000_000, 0, 1_000_000_000, middle))
                .isInstanceOf(PhotonCapacityException.class);
        assertThatCode(() -> forecast(350_000_000, 0, 1_000_000_000, middle)).doesNotThrowAnyException();
    }

    @Test
    void requireRoom_givenTasks_triesSome() {
        BitSet tried = new BitSet();
        StoreForecast.requireRoom("cells", 1, 0, 10, new Workers(1), () -> task -> {
            tried.set(task);
            return 0;
        });
        assertThat(tried.length()).isLessThanOrEqualTo(10);
        assertThat(tried.cardinality()).isGreaterThan(5);
    }

    @Test
    void requireRoom_givenStop_refusesNothing() {
        StopSignal stop = new StopSignal();
        stop.set();
        assertThatCode(() -> StoreForecast.requireRoom("cells", 0, 1, 10, new Workers(1, stop), () -> task -> 1))
                .doesNotThrowAnyException();
    }
}
