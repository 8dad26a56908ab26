package org.diacaustic.reproduction;

/**
 * A statement of the thesis, tested.
 *
 * @param evidence the numbers of the run that decide it
 */
record Verdict(Statement statement, Finding finding, String evidence) {}
