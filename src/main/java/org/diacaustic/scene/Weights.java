package org.diacaustic.scene;

/** What a light ray carries. */
public enum Weights {
    /** What the estimator needs. */
    AUTO,
    /** The flux of its part of light space, so that more rays are not more light. */
    SOLID_ANGLE,
    /** As much as any other ray: the thesis' way, which the expected count of photons makes up for where rays lie even. */
    NONE
}
