package org.diacaustic.material;

import org.diacaustic.math.Rgb;

/** A material's coefficients at one point: mutable, owned by one task, filled in by {@link Material#evaluate}. */
public final class Surface {
    /** The fraction of irradiance that leaves again in all directions, 0..1. */
    public final Rgb diffuse = new Rgb();

    /** The constant ambient irradiance, in W·m⁻². */
    public final Rgb ambient = new Rgb();

    /** The fraction mirrored, 0..1, besides what Fresnel reflects. */
    public final Rgb reflectivity = new Rgb();

    /** The fraction let through, 0..1, of what Fresnel does not reflect. */
    public final Rgb transparency = new Rgb();

    private final BumpMap.Gradient gradient = new BumpMap.Gradient();

    BumpMap.Gradient clearedGradient() {
        gradient.clear();
        return gradient;
    }
}
