package org.diacaustic.preprocess;

/** A way to choose light rays [Thesis 4.1 - 4.7.1]. */
public interface PreProcessor {
    String name();
}
