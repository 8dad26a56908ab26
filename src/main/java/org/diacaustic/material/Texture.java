package org.diacaustic.material;

import org.diacaustic.math.Rgb;
import org.diacaustic.shape.Hit;

/** A colour that may vary over a surface. Immutable and shared by threads. */
public interface Texture {

    /** Sets the colour at a completed hit. */
    void evaluate(Hit hit, Rgb color);

    /** Whether the map coordinates of the shape are used: if nothing needs them, they are not computed. */
    default boolean needsMap() {
        return false;
    }
}
