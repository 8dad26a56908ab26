package org.diacaustic.map;

import org.diacaustic.math.Rgb;

/**
 * The light that reaches surfaces after being refracted or reflected, as the forward pass found it: indirect irradiance, to
 * be asked for at any point. Immutable and shared by threads.
 */
public interface IlluminationMap {

    /** A reader for one task, with what it needs to work in; nothing is allocated per lookup after its first ones. */
    Lookup lookup();

    /**
     * Whether {@link Lookup#irradiance(Footprint, SurfacePoint, Rgb)} reads the footprint: whoever asks need not find out what
     * is not read.
     */
    default boolean readsFootprints() {
        return false;
    }

    /** The memory that the map takes. */
    long bytes();

    /** Asks a map, and counts what that costs. Owned by one task. */
    interface Lookup {

        /** Sets the irradiance at the point on its side, in W·m⁻². */
        void irradiance(SurfacePoint at, Rgb irradiance);

        /**
         * Sets the mean irradiance within a footprint, in W·m⁻².
         *
         * @param footprint around the point, and closed; maps that do not read footprints are asked at the point
         */
        default void irradiance(Footprint footprint, SurfacePoint at, Rgb irradiance) {
            irradiance(at, irradiance);
        }

        /** Nodes of the map's structure looked at so far: single photons and texels, and inner nodes. */
        long nodesExamined();

        /** Photons that have counted so far. */
        long photonsUsed();
    }
}
