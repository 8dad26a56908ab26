package org.diacaustic.render;

import org.diacaustic.map.IlluminationMap;

/**
 * The light that comes over specular surfaces, for one pass over the picture.
 *
 * @param map that is shown; null if there was no forward pass
 * @param coarser a map of the same rays, half as fine, that is only compared with the other; null if there is none
 */
record Illumination(IlluminationMap map, IlluminationMap coarser) {
    static final Illumination NONE = new Illumination(null, null);
}
