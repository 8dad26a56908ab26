/**
 * What people read of a study: one page, {@link org.diacaustic.page.StudyPage}, with sentences, charts, tables and pictures, all
 * drawn from a {@link org.diacaustic.study.StudyReport} and nothing else.
 *
 * <p>[Okabe and Ito 2008]: M. Okabe and K. Ito, Color Universal Design.
 */
package org.diacaustic.page;
