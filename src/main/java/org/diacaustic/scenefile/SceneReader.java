package org.diacaustic.scenefile;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.diacaustic.light.Light;
import org.diacaustic.material.Material;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.MediumLocator;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.scene.Settings;

/**
 * Reads scene files: YAML 1.2, described key by key in {@code scenes/scene.schema.json}. All problems of a file are
 * found in one reading.
 */
public final class SceneReader {
    private SceneReader() {}

    /**
     * Reads a scene file. What it names must lie in its folder.
     *
     * @return nothing if {@code problems} has errors afterwards
     */
    public static Optional<SceneFile> read(Path file, Problems problems) {
        return read(SceneDocument.read(file, problems), problems);
    }

    /** Reads a scene from a document, over which values may have been laid. */
    public static Optional<SceneFile> read(SceneDocument document, Problems problems) {
        MappingReader root = document.root();
        MappingReader view = root.mapping("camera");
        Camera camera = CameraReader.read(view);
        Color background = root.color("background").atLeast(0).or(Color.BLACK);
        List<Light> lights = root.variants("lights").stream()
                .map(LightReader::read)
                .flatMap(Optional::stream)
                .toList();
        Map<String, Material> materials = MaterialReader.readAll(root);
        List<SceneObject> objects = new ObjectReader(root, materials, problems).readAll();
        Settings settings = SettingsReader.read(root.mappingOrEmpty("settings"));
        root.finish();
        if (problems.hasErrors()) {
            return Optional.empty();
        }
        if (objects.isEmpty()) {
            root.warning("no objects: the picture shows the background only");
        }
        whereCameraStands(objects, camera.from()).ifPresent(where -> view.warning("from", where));
        if (lights.isEmpty()) {
            root.warning("no lights: the picture shows ambient light and background only");
        }
        return Optional.of(new SceneFile(new Scene(camera, lights, objects, background), settings));
    }

    /** What is doubtful about the place of the camera. */
    private static Optional<String> whereCameraStands(List<SceneObject> objects, Vector3 eye) {
        Optional<String> on = MediumLocator.surfaceAt(objects, eye)
                .map(object -> "the camera stands on the surface of " + object.name()
                        + "; rounding decides on which side of it");
        return on.or(() -> MediumLocator.opaqueAround(objects, eye)
                .map(object -> "the camera stands inside " + object.name() + ", which is opaque"));
    }
}
