/**
 * Work on several threads whose result does not depend on how many there are. Start reading at
 * {@link org.diacaustic.parallel.Workers}.
 */
package org.diacaustic.parallel;
