package org.diacaustic.render;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Supplier;
import org.diacaustic.parallel.Workers;

/** All tiles of a pass, rendered by as many renderers as there are threads. */
final class Tiles {
    private final int count;
    private final int stride;

    Tiles(RenderPlan plan) {
        count = plan.tileCount();
        stride = stride(count);
    }

    /**
     * Renders them, or as many as are done when the workers are stopped.
     *
     * @param makeRenderer called once by each thread
     * @return the renderers that there were
     */
    List<TileRenderer> render(Supplier<TileRenderer> makeRenderer, Workers workers, RenderProgress progress) {
        List<TileRenderer> renderers = Collections.synchronizedList(new ArrayList<>());
        workers.run(count, () -> {
            TileRenderer renderer = makeRenderer.get();
            renderers.add(renderer);
            return number -> {
                if (renderer.render(scattered(number), workers.stop())) {
                    progress.tile();
                }
            };
        });
        return renderers;
    }

    /** Tiles in an order that jumps over the picture, so that the time left can be told from those that are done. */
    private int scattered(int number) {
        return (int) ((long) number * stride % count);
    }

    private static int stride(int count) {
        int stride = (int) (count * 0.618) | 1;
        while (gcd(stride, count) != 1) {
            stride += 2;
        }
        return stride;
    }

    private static int gcd(int a, int b) {
        return b == 0 ? a : gcd(b, a % b);
    }
}
