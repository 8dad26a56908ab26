package org.diacaustic.trial;

import java.util.List;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.render.RadianceProbe;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.scenefile.Problem;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneDocument;
import org.diacaustic.scenefile.SceneReader;

/** What trials build their scenes of. */
final class Stage {
    /** A surface that sends all it receives out in all directions. */
    static final Material WHITE = Material.builder().diffuse(Color.WHITE).build();

    private Stage() {}

    static Vector3 vector(double[] components) {
        return new Vector3(components[0], components[1], components[2]);
    }

    static Material clear(Medium medium) {
        return Material.builder().transparency(Color.WHITE).inside(medium).build();
    }

    static Material clear(double indexOfRefraction) {
        return clear(Medium.of(indexOfRefraction));
    }

    /** A camera of one pixel. */
    static Camera eye(Vector3 from, Vector3 direction) {
        Vector3 view = direction.normalized();
        return Camera.builder()
                .from(from)
                .to(from.plus(view))
                .up(view.perpendicular())
                .size(1, 1)
                .build();
    }

    /** Eye rays that are followed to their end, for which the radiance of a matt surface is its irradiance × its diffuse. */
    static Settings.Builder plainLight() {
        return Settings.physical().toBuilder()
                .minimumThroughput(0)
                .normalizeDiffuse(false)
                .normalizeHighlights(false)
                .maps(MapSettings.builder().map(MapName.NONE).build());
    }

    static RadianceProbe probe(Scene scene, Settings.Builder settings) {
        return new RadianceProbe(RenderPlan.of(scene, settings.build()));
    }

    /** A number as scene files write it. */
    static String yaml(double number) {
        if (Double.isNaN(number)) {
            return ".nan";
        }
        return Double.isInfinite(number) ? (number > 0 ? ".inf" : "-.inf") : Double.toString(number);
    }

    /** What is wrong with the text of a scene file; nothing if it is read. */
    static List<String> faults(String text) {
        Problems problems = new Problems();
        SceneReader.read(SceneDocument.parse("scene", text, problems), problems);
        return problems.sorted().stream()
                .filter(problem -> problem.severity() == Problem.Severity.ERROR)
                .map(Problem::toString)
                .toList();
    }
}
