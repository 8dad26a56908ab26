/**
 * Paths of light through a scene: the walk over mirroring and refracting surfaces that the eye pass and the forward passes
 * share. Start reading at {@link org.diacaustic.transport.PathTracer}.
 */
package org.diacaustic.transport;
