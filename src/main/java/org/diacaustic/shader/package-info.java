/**
 * The thesis' shading models: what becomes of a shadow ray that meets a transparent surface [Thesis 3.2]. Start reading
 * at {@link org.diacaustic.shader.Shader}.
 */
package org.diacaustic.shader;
