/**
 * Scene files and mesh files: text to checked values, and every problem with its place.
 *
 * <p>Begin at {@link org.diacaustic.scenefile.SceneDocument}, which reads YAML, and {@link
 * org.diacaustic.scenefile.MappingReader}, through which its values are asked for.
 */
package org.diacaustic.scenefile;
