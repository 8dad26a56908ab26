/**
 * Pictures: linear radiance in memory, tone mapping to 8 bits, files, and how far two pictures differ. Read
 * {@link org.diacaustic.image.LinearImage} first, then {@link org.diacaustic.image.ImageFiles}.
 *
 * <p>PNG and TGA hold sRGB of exposure × radiance; HDR, PFM and OpenEXR hold the linear radiance itself. A writer
 * handles one {@link org.diacaustic.image.ImageFormat} and works row by row; a file appears under its name only when
 * whole. What cannot be stored is defined, never left to chance: in PNG and TGA not-a-number and negative values are 0
 * and +∞ is 255; in HDR not-a-number and negative values are 0 and what is too large is the largest value; PFM and
 * OpenEXR keep every bit pattern.
 *
 * <p>Sources: [Debevec 2001] the PFM format as HDR Shop reads and writes it; [IEC 61966-2-1] sRGB; [ISO 15948] PNG;
 * [OpenEXR file layout] the
 * document of that name of the OpenEXR project; [Ottosson 2020] A perceptual color space for image processing; [Rousselle
 * et al. 2011] Adaptive sampling and reconstruction using greedy error minimization; [Ward 1991] Real pixels, in Graphics
 * Gems II.
 */
package org.diacaustic.image;
