/**
 * The thesis again: {@link org.diacaustic.reproduction.Reproduction} runs every technique of the thesis on its three scenes and
 * lays the published tables beside what was counted.
 *
 * <p>[Thesis]: H. A. Bailey, Ray Tracing Techniques for Indirect Refracted Illumination, MSc thesis, Acadia University 1999.
 */
package org.diacaustic.reproduction;
