/**
 * Drawings: a {@link org.diacaustic.chart.Canvas} is a vector drawing, {@link org.diacaustic.chart.SvgCanvas}, or a picture,
 * {@link org.diacaustic.chart.PixelCanvas}. Knows nothing of what is drawn.
 */
package org.diacaustic.chart;
