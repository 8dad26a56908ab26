/**
 * Where the light that the forward pass brings is kept, and how it is read again: photons in primitive arrays, maps over
 * them. This package takes numbers (points, normals, object numbers, powers) and knows no scene. Start reading at
 * {@link org.diacaustic.map.IlluminationMap}.
 */
package org.diacaustic.map;
