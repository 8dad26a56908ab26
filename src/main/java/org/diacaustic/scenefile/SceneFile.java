package org.diacaustic.scenefile;

import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;

/** What a scene file holds: the scene, and how it wants to be rendered. */
public record SceneFile(Scene scene, Settings settings) {}
