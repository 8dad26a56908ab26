package org.diacaustic.study;

/**
 * What one of the thesis' shading models does without any forward pass; no budget makes it better.
 *
 * @param shader its name
 * @param run the one picture
 */
public record ShadingStudy(String shader, StudyRun run) {}
