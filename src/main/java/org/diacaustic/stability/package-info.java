/**
 * Numeric cases with exact answers, what was found of them, and how far that is off: numbers only. What a case asks for is
 * asked of the code that renders by {@link org.diacaustic.trial}, and of the
 * program by {@link org.diacaustic.fault}.
 */
package org.diacaustic.stability;
