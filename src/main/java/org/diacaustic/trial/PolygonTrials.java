package org.diacaustic.trial;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.diacaustic.math.Ray;
import org.diacaustic.scenefile.FileScope;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneDocument;
import org.diacaustic.scenefile.SceneFile;
import org.diacaustic.scenefile.SceneReader;
import org.diacaustic.shape.Shape;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Outlines in the plane and what they surround. */
final class PolygonTrials {
    private static final String SCENE = "camera: {from: [0, 0, 9], to: [0, 0, 0]}\nobjects:\n  - ";

    private PolygonTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "polygon_contains",
                "The outline read from a scene file as a polygon or, if it is refused for not being convex, as a face of a mesh in an"
                        + " OBJ file, the way for such outlines. A point is inside if a ray through it, at right angles to the plane,"
                        + " meets the shape. A point of an edge: the ray must meet the shape, and that of the outline in the other"
                        + " order, which is how a neighbour has the edge. Where rejection is acceptable, the polygon's is what is"
                        + " looked at.",
                PolygonTrials::contains);
    }

    private static void contains(NumericCase asked, Checks checks) throws IOException {
        double[][] vertices = asked.inputs().rows("vertices");
        double[][] points = asked.inputs().rows("points");
        Problems problems = new Problems();
        Optional<Shape> polygon = polygon(vertices, problems);
        if (polygon.isEmpty() && asked.acceptable().stream().anyMatch(answer -> answer.contains("rejected"))) {
            String message = problems.toString();
            checks.rule("rejection", "names the polygon", message, message.contains("objects[0].polygon"));
            checks.note("rejected: " + message);
            return;
        }
        Shape shape = polygon.isPresent() ? polygon.get() : face(vertices);
        Shape reversed =
                polygon.isPresent() ? polygon(reversed(vertices), problems).orElseThrow() : face(reversed(vertices));
        List<?> expected = asked.expected().list(asked.expected().has("inside") ? "inside" : "even_odd");
        for (int i = 0; i < points.length; i++) {
            boolean inside = isMet(shape, points[i]);
            String what = "point " + i;
            if (expected.get(i) instanceof Boolean wanted) {
                checks.same(what, wanted, inside);
            } else {
                checks.rule(
                        what + " on an edge",
                        "met, in both orders",
                        inside + ", " + isMet(reversed, points[i]),
                        inside && isMet(reversed, points[i]));
            }
        }
        checks.note(polygon.isPresent() ? "as a polygon" : "as a face of a mesh");
    }

    private static boolean isMet(Shape shape, double[] point) {
        Ray ray = new Ray();
        ray.set(point[0], point[1], 1, 0, 0, -1);
        return shape.intersect(ray);
    }

    private static double[][] reversed(double[][] vertices) {
        double[][] reversed = new double[vertices.length][];
        for (int i = 0; i < vertices.length; i++) {
            reversed[i] = vertices[vertices.length - 1 - i];
        }
        return reversed;
    }

    private static Optional<Shape> polygon(double[][] vertices, Problems problems) {
        StringBuilder text = new StringBuilder(SCENE).append("polygon: {material: {diffuse: 1}, vertices: [");
        for (double[] vertex : vertices) {
            text.append('[').append(vertex[0]).append(", ").append(vertex[1]).append(", 0], ");
        }
        text.append("]}\n");
        return shape(SceneReader.read(SceneDocument.parse("outline.yaml", text.toString(), problems), problems));
    }

    private static Shape face(double[][] vertices) throws IOException {
        Path folder = Files.createTempDirectory("outline");
        Path mesh = folder.resolve("outline.obj");
        try {
            StringBuilder text = new StringBuilder();
            StringBuilder face = new StringBuilder("f");
            for (int i = 0; i < vertices.length; i++) {
                text.append("v ")
                        .append(vertices[i][0])
                        .append(' ')
                        .append(vertices[i][1])
                        .append(" 0\n");
                face.append(' ').append(i + 1);
            }
            Files.writeString(mesh, text.append(face).append('\n'));
            String scene = SCENE + "mesh: {material: {diffuse: 1}, file: outline.obj, smooth: false}\n";
            Problems problems = new Problems();
            SceneDocument document = SceneDocument.parse(
                    "outline.yaml", scene, FileScope.inFolderOf(folder.resolve("outline.yaml")), problems);
            return shape(SceneReader.read(document, problems))
                    .orElseThrow(() -> new IllegalStateException(problems.toString()));
        } finally {
            Files.deleteIfExists(mesh);
            Files.delete(folder);
        }
    }

    private static Optional<Shape> shape(Optional<SceneFile> file) {
        return file.map(read -> read.scene().objects().get(0).shape());
    }
}
