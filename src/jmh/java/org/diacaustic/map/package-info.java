/**
 * Benchmarks of the photon store and of ways to find photons in it, and the ways that lost: a left-balanced implicit tree, the
 * thesis' tree of photon objects, a hash grid. All pass one contract test.
 */
package org.diacaustic.map;
