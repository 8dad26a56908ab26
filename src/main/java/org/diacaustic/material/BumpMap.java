package org.diacaustic.material;

import org.diacaustic.math.Rgb;
import org.diacaustic.shape.Hit;

/**
 * A height over a surface that tilts the normal and moves nothing [Thesis 2.4; Blinn 1978, "Simulation of Wrinkled
 * Surfaces"]. Several bumps on one surface add up.
 */
public interface BumpMap {

    /** Adds the gradient of the height at a completed hit; its part along the normal does not matter. */
    void addGradient(Hit hit, Gradient gradient);

    /** Whether the map coordinates and tangents of the shape are used. */
    default boolean needsMap() {
        return false;
    }

    /** A sum of gradients, without unit: height in scene units per scene unit. Mutable, owned by one task. */
    final class Gradient {
        double x;
        double y;
        double z;

        /** Room for a bump map to look up a colour. */
        final Rgb scratch = new Rgb();

        public void clear() {
            x = 0;
            y = 0;
            z = 0;
        }

        public void add(double gx, double gy, double gz) {
            x += gx;
            y += gy;
            z += gz;
        }

        /** Tilts the shading normal of the hit: n′ ∥ n − (g − (g·n) n). No slope leaves it as it is, to the bit. */
        void tilt(Hit hit) {
            if (x == 0 && y == 0 && z == 0) {
                return;
            }
            double nx = hit.shadingX;
            double ny = hit.shadingY;
            double nz = hit.shadingZ;
            double along = x * nx + y * ny + z * nz;
            double tx = nx - (x - along * nx);
            double ty = ny - (y - along * ny);
            double tz = nz - (z - along * nz);
            double length = Math.sqrt(tx * tx + ty * ty + tz * tz);
            hit.shadingX = tx / length;
            hit.shadingY = ty / length;
            hit.shadingZ = tz / length;
        }
    }
}
