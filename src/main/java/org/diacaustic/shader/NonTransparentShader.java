package org.diacaustic.shader;

import org.diacaustic.math.Rgb;

/**
 * The non-transparent shading model: whatever lies between a point and a light stops the light [Thesis 3.2.1]. What
 * passes through transparent objects must come from a map.
 */
public final class NonTransparentShader implements Shader {
    public static final String NAME = "non-transparent";

    @Override
    public String name() {
        return NAME;
    }

    @Override
    public boolean transmit(ShadowRay shadow, Rgb transmittance) {
        if (shadow.isStoppedByLastBlocker() || shadow.visit(shadow.anyBlocker)) {
            transmittance.set(0, 0, 0);
            return false;
        }
        transmittance.set(1, 1, 1);
        return true;
    }
}
