package org.diacaustic.material;

import org.diacaustic.math.Rgb;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.InverseMapping;

/** A texture laid on a surface through an inverse mapping of its own in place of the shape's. */
public record MappedTexture(Texture texture, InverseMapping mapping) implements Texture {

    @Override
    public void evaluate(Hit hit, Rgb color) {
        mapping.map(hit);
        texture.evaluate(hit, color);
    }
}
