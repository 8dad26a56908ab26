package org.diacaustic.render;

import java.util.function.DoubleConsumer;

/**
 * Counts the parts of a render as they are finished, and tells a listener of each: tiles, and equal parts of forward passes. A
 * forward pass is as many tiles' worth of work as if a light ray were as much as an eye ray. Safe for many threads.
 */
final class RenderProgress {
    private static final int MOST_FORWARD_PARTS = 1 << 20;

    private final ProgressListener listener;
    private final int forwardParts;
    private final int total;
    private int done;

    /**
     * @param passes over the picture
     * @param hasForward whether each begins with a forward pass
     */
    RenderProgress(RenderPlan plan, int passes, boolean hasForward, ProgressListener listener) {
        this.listener = listener;
        int tiles = plan.tileCount();
        int most = Math.min(MOST_FORWARD_PARTS, Integer.MAX_VALUE / passes - tiles);
        this.forwardParts =
                hasForward ? (int) Math.min(most, Math.rint(tiles * (plan.lightRays() / plan.eyeRays()))) : 0;
        this.total = passes * (tiles + forwardParts);
    }

    /** A forward pass begins: takes which part of it is done, 0 to 1. */
    synchronized DoubleConsumer forwardPass() {
        int before = done;
        return part -> advance(before + (int) (part * forwardParts));
    }

    /** A tile is done. */
    synchronized void tile() {
        advance(done + 1);
    }

    /** Tells the listener of every part up to this number. */
    private synchronized void advance(int parts) {
        while (done < parts) {
            done++;
            listener.progressed(done, total);
        }
    }
}
