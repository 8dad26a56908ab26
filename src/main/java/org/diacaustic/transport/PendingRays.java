package org.diacaustic.transport;

import java.util.Arrays;
import org.diacaustic.scene.SceneIndex;

/**
 * The rays of one eye ray's tree that are still to be followed, last in first out. It takes the place of recursion, so
 * that no depth can overflow the thread's stack: two mirrors that face each other keep one ray here.
 */
final class PendingRays {
    private final SceneIndex scene;
    private PendingRay[] rays = new PendingRay[0];
    private int count;

    PendingRays(SceneIndex scene) {
        this.scene = scene;
    }

    boolean isEmpty() {
        return count == 0;
    }

    void clear() {
        count = 0;
    }

    /** Adds a ray, for the caller to fill: it still holds what one of its predecessors was. */
    PendingRay push() {
        if (count == rays.length) {
            rays = Arrays.copyOf(rays, Math.max(16, 2 * count));
            for (int i = count; i < rays.length; i++) {
                rays[i] = new PendingRay(scene);
            }
        }
        return rays[count++];
    }

    /** Takes the last ray; it is valid until the next push. */
    PendingRay pop() {
        return rays[--count];
    }
}
