package org.diacaustic.study;

import java.io.IOException;
import java.util.Map;
import org.diacaustic.scenefile.SceneFile;

/** Reads one scene again and again, each time with other settings laid over it. */
@FunctionalInterface
public interface SceneSource {

    /**
     * Reads the scene.
     *
     * @param overrides keys of the scene's settings with their values, as the command line writes them
     * @throws IOException if it cannot be read
     */
    SceneFile read(Map<String, String> overrides) throws IOException;
}
