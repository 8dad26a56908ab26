package org.diacaustic.render;

/**
 * One round of a {@link Refinement}.
 *
 * @param lightRays planned for a forward pass; 0 if there is none
 * @param passes that the picture is the mean of at the end of the round
 * @param seconds that the round took, wall clock
 * @param estimate the error or the noise of the picture then; not a number if there is no telling, as for a round that was
 *     stopped
 */
public record Round(long lightRays, int passes, double seconds, double estimate) {}
