package org.diacaustic.map;

import org.diacaustic.math.Rgb;

/**
 * The light that reaches surfaces after being refracted or reflected, as the forward pass found it: indirect irradiance, to
 * be asked for at any point. Immutable and shared by threads.
 */
public interface IlluminationMap {

    /** A reader for one task, with what it needs to work in; nothing is allocated per lookup after its first ones. */
    Lookup lookup();

    /** The memory that the map takes. */
    long bytes();

    /** Asks a map, and counts what that costs. Owned by one task. */
    interface Lookup {

        /** Sets the irradiance at the point on its side, in W·m⁻². */
        void irradiance(SurfacePoint at, Rgb irradiance);

        /** Nodes of the map's structure looked at so far: single photons and texels, and inner nodes. */
        long nodesExamined();

        /** Photons that have counted so far. */
        long photonsUsed();
    }
}
