/**
 * What renders can say about the thesis and about each other. {@link org.diacaustic.study.Reproduction} runs every
 * technique of the thesis on its three scenes and lays the published tables beside what was counted. {@link
 * org.diacaustic.study.Study} holds techniques against a reference on any scene: error by light rays and by time.
 * {@link org.diacaustic.study.CellsChart} draws the cells of a caustic mesh.
 *
 * <p>[Thesis]: H. A. Bailey, Ray Tracing Techniques for Indirect Refracted Illumination, MSc thesis, Acadia University 1999.
 */
package org.diacaustic.study;
