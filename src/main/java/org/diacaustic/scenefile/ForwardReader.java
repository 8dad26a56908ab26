package org.diacaustic.scenefile;

import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.Weights;

/** Reads the keys of {@code settings} that say how light is traced forward. */
final class ForwardReader {
    /** More would take days on any machine. */
    private static final long MOST_RAYS = 1_000_000_000_000L;

    /** So that all batches together can be counted. */
    private static final long MOST_RAYS_A_BATCH = 1_000_000_000;

    private ForwardReader() {}

    /** @param start what holds where nothing is said */
    static ForwardSettings read(MappingReader in, ForwardSettings start) {
        ForwardSettings.Builder forward = start.toBuilder();
        in.text("preprocessor").optional().ifPresent(forward::preProcessor);
        in.longInteger("rays").atLeast(1).atMost(MOST_RAYS).optional().ifPresent(forward::rays);
        in.integer("passes").atLeast(1).optional().ifPresent(forward::passes);
        in.integer("light-depth").atLeast(0).optional().ifPresent(forward::maxDepth);
        in.flag("light-reflections").optional().ifPresent(forward::followReflections);
        in.choice("light-weights", Weights.class).optional().ifPresent(forward::weights);
        in.flag("aim-at-specular").optional().ifPresent(forward::aimAtSpecular);
        in.flag("lattice-shift").optional().ifPresent(forward::shiftLattice);
        in.flag("uniform-directions").optional().ifPresent(forward::uniformDirections);
        in.integer("lattice-size").atLeast(1).optional().ifPresent(forward::latticeSize);
        in.integer("split").atLeast(2).atMost(64).optional().ifPresent(forward::split);
        in.integer("split-depth").atLeast(0).atMost(16).optional().ifPresent(forward::splitDepth);
        in.longInteger("base-rays").atLeast(1).atMost(MOST_RAYS).optional().ifPresent(forward::baseRays);
        in.longInteger("batch-rays")
                .atLeast(1)
                .atMost(MOST_RAYS_A_BATCH)
                .optional()
                .ifPresent(forward::batchRays);
        in.number("batch-spread").atLeast(0).atMost(2).optional().ifPresent(forward::batchSpread);
        return forward.build();
    }
}
