package org.diacaustic.transport;

import org.diacaustic.material.ScatterRules;
import org.diacaustic.material.TransportMode;

/**
 * How paths are followed.
 *
 * @param scattering what surfaces do to light
 * @param mode what travels along the path
 * @param maxDepth how often a path may be mirrored or refracted
 * @param minimumThroughput paths that carry a smaller fraction of what started are cut off
 * @param followsReflections whether mirrored rays are followed; those that are not are cut off
 * @param asksListOnly whether nothing but the scene's list of objects is asked, so that tests mean what the thesis' do
 */
public record PathRules(
        ScatterRules scattering,
        TransportMode mode,
        int maxDepth,
        double minimumThroughput,
        boolean followsReflections,
        boolean asksListOnly) {}
