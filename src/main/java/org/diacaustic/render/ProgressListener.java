package org.diacaustic.render;

/**
 * Hears how far a render is. Called by one thread at a time, but not always the same one; an exception from it ends the
 * render and is thrown to whoever runs it.
 */
@FunctionalInterface
public interface ProgressListener {

    /**
     * @param done parts finished, growing by 1 from call to call; from 1 again at every round of a {@link Refinement} of a mesh
     *     without a deadline
     * @param total parts in all
     */
    void progressed(int done, int total);
}
