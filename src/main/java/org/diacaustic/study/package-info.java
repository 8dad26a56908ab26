/**
 * What techniques can say about each other. {@link org.diacaustic.study.Study} holds techniques against a reference on any
 * scene: error by light rays, by time, by work and by memory. {@link org.diacaustic.study.CellsChart} draws the cells of a
 * caustic mesh.
 *
 * <p>[Thesis]: H. A. Bailey, Ray Tracing Techniques for Indirect Refracted Illumination, MSc thesis, Acadia University 1999.
 */
package org.diacaustic.study;
