/**
 * Faults that the program itself is put to: broken files, impossible options, limits, signals. Each is an operation of numeric
 * cases that starts the program as its users do, and looks at what it says, leaves and returns.
 */
package org.diacaustic.fault;
