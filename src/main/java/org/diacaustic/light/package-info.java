/**
 * What emits light, and how much of it arrives unhindered at a point. Intensity is in W·sr⁻¹, radiance in W·m⁻²·sr⁻¹,
 * irradiance in W·m⁻². Start reading at {@link org.diacaustic.light.Light}.
 */
package org.diacaustic.light;
