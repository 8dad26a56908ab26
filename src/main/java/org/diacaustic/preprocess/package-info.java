/**
 * The forward pass: light rays from the lights over refracting and mirroring surfaces to where they land. Start reading at
 * {@link org.diacaustic.preprocess.PreProcessor}.
 */
package org.diacaustic.preprocess;
