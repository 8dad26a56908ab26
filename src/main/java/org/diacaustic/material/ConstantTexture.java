package org.diacaustic.material;

import org.diacaustic.math.Color;
import org.diacaustic.math.Rgb;
import org.diacaustic.shape.Hit;

/** The same colour everywhere. */
public record ConstantTexture(Color color) implements Texture {
    public static final ConstantTexture BLACK = new ConstantTexture(Color.BLACK);

    @Override
    public void evaluate(Hit hit, Rgb result) {
        result.set(color);
    }
}
