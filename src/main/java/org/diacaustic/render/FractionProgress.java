package org.diacaustic.render;

/** Tells a listener of equal parts by the fraction that is done; what would be a step back is not told. Safe for many threads. */
final class FractionProgress {
    private static final int PARTS = 1000;

    private final ProgressListener listener;
    private int done;

    FractionProgress(ProgressListener listener) {
        this.listener = listener;
    }

    /** So much is done, 0 to 1. */
    synchronized void at(double fraction) {
        int parts = (int) (PARTS * Math.min(1, fraction));
        while (done < parts) {
            done++;
            listener.progressed(done, PARTS);
        }
    }
}
