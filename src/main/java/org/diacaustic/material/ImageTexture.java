package org.diacaustic.material;

import org.diacaustic.image.LinearImage;
import org.diacaustic.math.Rgb;
import org.diacaustic.shape.Hit;

/** A picture on a surface, through the surface's map coordinates. */
public final class ImageTexture implements Texture {
    private final ImageSampler sampler;

    /**
     * @param image linear light
     * @param repeatU how often it is repeated across the map, at least 1
     * @param repeatV and up the map
     */
    public ImageTexture(LinearImage image, int repeatU, int repeatV) {
        this.sampler = new ImageSampler(image, repeatU, repeatV);
    }

    @Override
    public void evaluate(Hit hit, Rgb color) {
        sampler.sample(hit.u, hit.v, color);
    }

    @Override
    public boolean needsMap() {
        return true;
    }
}
