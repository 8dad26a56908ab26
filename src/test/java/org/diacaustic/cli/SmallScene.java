package org.diacaustic.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A scene of a few lines, which renders in no time; tests change a line of it. */
final class SmallScene {
    static final String TEXT = """
            camera: {from: [0, 2, 6], to: [0, 0, 0], size: [20, 16]}
            lights:
              - point: {at: [0, 9, 0], intensity: 100}
            materials:
              grey: {diffuse: 0.5}
              glass: {transparency: 0.9, ior: 1.5}
            objects:
              - sphere:
                  name: ball
                  at: [0, 0, 0]
                  radius: 1
                  material: glass
              - plane: {name: floor, at: [0, -1, 0], normal: [0, 1, 0], material: grey}
            settings: {rays: 2000}
            """;

    private SmallScene() {}

    static Path in(Path folder) throws IOException {
        return Files.writeString(folder.resolve("scene.yaml"), TEXT);
    }

    /** The scene with one piece of its text replaced. */
    static Path in(Path folder, String piece, String replacement) throws IOException {
        if (!TEXT.contains(piece)) {
            throw new IllegalArgumentException("the scene does not contain " + piece);
        }
        return Files.writeString(folder.resolve("scene.yaml"), TEXT.replace(piece, replacement));
    }
}
