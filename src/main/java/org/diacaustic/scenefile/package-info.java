/**
 * Scene files and mesh files: text to checked values, and every problem with its place.
 *
 * <p>Begin at {@link org.diacaustic.scenefile.SceneReader}. Below it, {@link org.diacaustic.scenefile.SceneDocument} reads
 * YAML, {@code MappingReader} asks for its values, and a reader for each part of a scene makes the part.
 */
package org.diacaustic.scenefile;
