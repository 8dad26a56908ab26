package org.diacaustic.shape;

/**
 * From a point of a surface to coordinates u, v of a map [Thesis 2.4]. Besides each shape's own mapping, a texture may
 * bring one of these.
 */
public interface InverseMapping {

    /** Sets {@code hit.u}, {@code hit.v} in 0..1 and the tangents, from the completed hit's point and normal. */
    void map(Hit hit);
}
