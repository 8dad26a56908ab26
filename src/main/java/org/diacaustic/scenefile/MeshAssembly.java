package org.diacaustic.scenefile;

import java.util.function.IntFunction;
import org.diacaustic.math.Arithmetic;
import org.diacaustic.shape.MeshData;

/** The last steps that all mesh formats share: faces to triangles, and what is worth a warning. */
final class MeshAssembly {
    private final Place place;
    private final Problems problems;

    MeshAssembly(Place place, Problems problems) {
        this.place = place;
        this.problems = problems;
    }

    /** Cuts faces in triangles; {@code tooManyCorners} makes the fault for a face that is too large to cut. */
    int[] triangulate(Polygons faces, double[] vertices, IntFunction<MeshFault> tooManyCorners) {
        IntList triangles = new IntList();
        PolygonCutter cutter = new PolygonCutter(vertices, triangles);
        for (int face = 0; face < faces.count(); face++) {
            int[] polygon = new int[faces.end(face) - faces.begin(face)];
            for (int i = 0; i < polygon.length; i++) {
                polygon[i] = faces.corner(faces.begin(face) + i);
            }
            if (!cutter.cut(polygon)) {
                throw tooManyCorners.apply(face);
            }
        }
        if (cutter.uncertainCount() > 0) {
            warn(cutter.uncertainCount() + " polygons cross or touch themselves; their triangles may overlap");
        }
        return triangles.toArray();
    }

    /**
     * @param normals of each vertex, or null
     * @param maps of each vertex, or null
     */
    MeshData finish(double[] vertices, int[] triangles, double[] normals, double[] maps) {
        if (triangles.length == 0) {
            throw MeshFault.atLine(0, "holds no triangles");
        }
        int flat = 0;
        for (int i = 0; i < triangles.length; i += 3) {
            flat += hasNoArea(vertices, 3 * triangles[i], 3 * triangles[i + 1], 3 * triangles[i + 2]) ? 1 : 0;
        }
        if (flat > 0) {
            warn(flat + " of " + triangles.length / 3 + " triangles have no area; no light meets them");
        }
        return new MeshData(vertices, triangles, withoutZeros(normals), maps);
    }

    private double[] withoutZeros(double[] normals) {
        if (normals == null) {
            return null;
        }
        int zeros = 0;
        for (int i = 0; i < normals.length; i += 3) {
            zeros += normals[i] == 0 && normals[i + 1] == 0 && normals[i + 2] == 0 ? 1 : 0;
        }
        if (zeros > 0) {
            warn(zeros + " normals are zero, so none of the file's normals are used");
        }
        return zeros > 0 ? null : normals;
    }

    void warn(String message) {
        problems.warning(place, "", message);
    }

    private static boolean hasNoArea(double[] v, int a, int b, int c) {
        for (int axis = 0; axis < 3; axis++) {
            int u = (axis + 1) % 3;
            int w = (axis + 2) % 3;
            double area = Arithmetic.differenceOfProducts(
                    v[b + u] - v[a + u], v[c + w] - v[a + w], v[b + w] - v[a + w], v[c + u] - v[a + u]);
            if (area != 0) {
                return false;
            }
        }
        return true;
    }
}
