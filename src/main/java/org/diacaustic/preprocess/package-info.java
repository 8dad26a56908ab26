/**
 * The forward pass: light rays from the lights over refracting and mirroring surfaces to where they land. Start reading at
 * {@link org.diacaustic.preprocess.PreProcessor}. {@link org.diacaustic.preprocess.ForwardPass} makes photons of them,
 * {@link org.diacaustic.preprocess.MeshPass} cells between them, and says how these are asked about single points exactly.
 */
package org.diacaustic.preprocess;
