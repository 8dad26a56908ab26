/**
 * What a surface does to light: colours that vary over it, bumps, and the one scatter function that the eye pass and
 * the forward passes share. Materials trace nothing. Start reading at {@link org.diacaustic.material.Scattering}.
 *
 * <p>Diffuse, reflectivity and transparency are fractions per colour; ambient is an irradiance in W·m⁻²; absorption is
 * in 1 ÷ scene unit.
 */
package org.diacaustic.material;
