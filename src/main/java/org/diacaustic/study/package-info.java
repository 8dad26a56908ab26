/**
 * Techniques held against each other. {@link org.diacaustic.study.Study} renders one scene with each, with several budgets and
 * seeds, and holds the pictures against a {@link org.diacaustic.study.Reference} that owes nothing to any of them; {@link
 * org.diacaustic.study.StudyReport} holds what was found, as numbers: error by light rays, by time, by work and by memory. {@link
 * org.diacaustic.study.CellsChart} draws the cells of a caustic mesh.
 *
 * <p>[Thesis]: H. A. Bailey, Ray Tracing Techniques for Indirect Refracted Illumination, MSc thesis, Acadia University 1999.
 */
package org.diacaustic.study;
