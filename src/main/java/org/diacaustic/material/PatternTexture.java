package org.diacaustic.material;

import org.diacaustic.math.Color;
import org.diacaustic.math.Rgb;
import org.diacaustic.shape.Hit;

/** Two colours mixed by a pattern: {@code first} where it is 0, {@code second} where it is 1. */
public record PatternTexture(Pattern pattern, Color first, Color second) implements Texture {

    @Override
    public void evaluate(Hit hit, Rgb color) {
        double share = pattern.at(hit);
        double rest = 1 - share;
        color.set(
                rest * first.red() + share * second.red(),
                rest * first.green() + share * second.green(),
                rest * first.blue() + share * second.blue());
    }

    @Override
    public boolean needsMap() {
        return pattern.needsMap();
    }
}
