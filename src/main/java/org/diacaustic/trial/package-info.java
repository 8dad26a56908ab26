/**
 * The operations of numeric cases: each puts its cases to the code that renders, and to no other. A class is a field of
 * operations; {@link org.diacaustic.trial.Trials} knows them all.
 */
package org.diacaustic.trial;
