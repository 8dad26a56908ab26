/**
 * The forward pass: light rays from the lights over refracting and mirroring surfaces to where they land. Start reading at
 * {@link org.diacaustic.preprocess.PreProcessor}. Cells for a caustic mesh are made by
 * {@link org.diacaustic.preprocess.MeshPass}, which says how such a mesh is asked about single points exactly.
 */
package org.diacaustic.preprocess;
