package org.diacaustic.reproduction;

/** Carries out experiments. */
interface Laboratory {

    /**
     * Runs one experiment once.
     *
     * @param seed of everything random; the same seed gives the same counts and the same picture
     * @param withPicture whether a picture is wanted too
     */
    Measurement measure(Experiment experiment, long seed, boolean withPicture);
}
