package org.diacaustic.study;

import org.diacaustic.image.LinearImage;

/**
 * One picture made by a technique.
 *
 * @param rays light rays that it was to choose
 * @param lightRays all light rays that were followed, with all that became of them
 * @param seconds of the whole render in a program that is warm, wall clock
 * @param processorSeconds of all threads meanwhile; not a number if the system does not tell
 * @param picture linear radiance
 */
public record StudyRun(
        long rays, long lightRays, double seconds, double processorSeconds, LinearImage picture, PictureError error) {}
