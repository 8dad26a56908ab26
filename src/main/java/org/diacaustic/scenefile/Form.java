package org.diacaustic.scenefile;

import org.diacaustic.scenefile.Node.Mapping;
import org.diacaustic.scenefile.Node.Scalar;
import org.diacaustic.scenefile.Node.Sequence;

/** The outward form of a value, for keys that allow more than one. */
enum Form {
    ABSENT,
    NUMBER,
    TEXT,
    LIST,
    MAPPING;

    static Form of(Node node) {
        if (node instanceof Scalar scalar) {
            return NumberText.isNumber(scalar) ? NUMBER : TEXT;
        }
        return node instanceof Sequence ? LIST : node instanceof Mapping ? MAPPING : ABSENT;
    }
}
