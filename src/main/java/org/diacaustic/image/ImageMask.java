package org.diacaustic.image;

/** Which pixels of an image count. */
@FunctionalInterface
public interface ImageMask {
    /** Every pixel counts. */
    ImageMask ALL = (x, y) -> true;

    /** Whether the pixel in column x and row y, from the top left, counts. */
    boolean includes(int x, int y);
}
