package org.diacaustic.render;

import org.diacaustic.image.LinearImage;
import org.diacaustic.math.Rgb;

/**
 * The part of a picture that no map brings. It is the same whatever the map, so a picture that is rendered again with another
 * map takes it from here. Pixels may be kept by different threads.
 */
final class OtherLight {
    private final LinearImage image;
    /** Of the render that it was kept from; null before. */
    private Counters counters;

    OtherLight(int width, int height) {
        image = new LinearImage(width, height);
    }

    /** Whether all of it is there. */
    boolean isThere() {
        return counters != null;
    }

    /** Every pixel has been kept by a render that counted this. */
    void complete(Counters counted) {
        counters = counted;
    }

    void keep(int x, int y, Rgb radiance) {
        image.set(x, y, radiance);
    }

    void recall(int x, int y, Rgb radiance) {
        int offset = image.offset(x, y);
        float[] samples = image.samples();
        radiance.set(samples[offset], samples[offset + 1], samples[offset + 2]);
    }

    /** Adds what was counted for this part of the picture. */
    void addCounts(Counters sum) {
        sum.addOtherLight(counters);
    }
}
