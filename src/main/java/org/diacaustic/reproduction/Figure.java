package org.diacaustic.reproduction;

import java.util.Locale;
import java.util.Optional;
import org.diacaustic.image.LinearImage;

/**
 * A numbered picture of the thesis, rendered or drawn again.
 *
 * @param svg the same as a drawing, for charts
 */
record Figure(int number, ThesisScene scene, String caption, LinearImage picture, Optional<String> svg) {

    /** The name of its files, without ending. */
    String fileName() {
        return String.format(Locale.ROOT, "figure-%02d", number);
    }
}
