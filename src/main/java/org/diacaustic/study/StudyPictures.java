package org.diacaustic.study;

import java.util.Optional;
import org.diacaustic.image.LinearImage;

/** Where the pictures of a study are kept: those of the first seed. */
@FunctionalInterface
public interface StudyPictures {
    /** Linear radiance; nothing if it is not there. */
    Optional<LinearImage> picture(Technique technique, StudyPoint point);
}
