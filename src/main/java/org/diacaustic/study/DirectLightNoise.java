package org.diacaustic.study;

import java.io.IOException;
import java.util.Arrays;
import java.util.Map;
import org.diacaustic.image.LinearImage;
import org.diacaustic.parallel.Workers;

/**
 * Direct light of lamps with an extent has noise of its own, which says nothing of techniques for indirect light. A
 * reference has the direct light of the scene's seed; pictures of other seeds get that in place of their own.
 */
final class DirectLightNoise {
    /** Null if all seeds have the same direct light. */
    private final LinearImage ofReference;

    /** @throws IOException if the scene cannot be read */
    DirectLightNoise(SceneSource source, Reference reference, long seed, Workers workers) throws IOException {
        if (reference.origin() == Reference.Origin.GIVEN) {
            ofReference = null;
            return;
        }
        Technique alone = new Technique("direct light", Technique.Way.OVER_A_MAP, Map.of(), 0);
        TechniqueRender render = new TechniqueRender(source, alone, workers);
        LinearImage direct = render.directWith(seed);
        boolean isSame =
                Arrays.equals(direct.samples(), render.directWith(seed + 1).samples());
        ofReference = isSame ? null : direct;
    }

    /** The picture with the reference's direct light. */
    LinearImage exchange(LinearImage picture, TechniqueRender render, long seed) {
        if (ofReference == null) {
            return picture;
        }
        LinearImage own = render.directWith(seed);
        LinearImage exchanged = new LinearImage(picture.width(), picture.height());
        for (int i = 0; i < exchanged.samples().length; i++) {
            exchanged.samples()[i] =
                    picture.samples()[i] - own.samples()[i] + ofReference.samples()[i];
        }
        return exchanged;
    }
}
