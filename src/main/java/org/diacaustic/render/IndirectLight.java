package org.diacaustic.render;

import org.diacaustic.map.IlluminationMap;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.material.Surface;
import org.diacaustic.math.Rgb;
import org.diacaustic.shape.Hit;

/**
 * The light that reaches a hit after being refracted or mirrored, as the map of the forward pass has it: the A of the thesis'
 * equation [Thesis 1.3, 3.3]. Owned by one task.
 */
final class IndirectLight {
    /** Null if there was no forward pass. */
    private final IlluminationMap.Lookup lookup;

    private final double diffuseFactor;
    private final boolean looksEverywhere;
    private final SurfacePoint at = new SurfacePoint();
    private final Rgb irradiance = new Rgb();

    /** @param map null if there was no forward pass */
    IndirectLight(RenderPlan plan, IlluminationMap map) {
        this.lookup = map == null ? null : map.lookup();
        this.diffuseFactor = plan.diffuseFactor();
        this.looksEverywhere = plan.settings().usesListOrder();
    }

    void add(int object, int side, Hit hit, Surface surface, Rgb throughput, Rgb radiance) {
        if (lookup == null || (surface.diffuse.isBlack() && !looksEverywhere)) {
            return;
        }
        at.x = hit.x;
        at.y = hit.y;
        at.z = hit.z;
        at.normalX = side * hit.normalX;
        at.normalY = side * hit.normalY;
        at.normalZ = side * hit.normalZ;
        at.object = object;
        at.front = side > 0;
        lookup.irradiance(at, irradiance);
        irradiance.multiply(surface.diffuse).scale(diffuseFactor);
        radiance.addProduct(throughput, irradiance);
    }

    long nodesExamined() {
        return lookup == null ? 0 : lookup.nodesExamined();
    }

    long photonsUsed() {
        return lookup == null ? 0 : lookup.photonsUsed();
    }
}
