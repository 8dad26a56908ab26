package org.diacaustic.trial;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.diacaustic.math.Ray;
import org.diacaustic.math.SampleStream;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.MeshData;
import org.diacaustic.shape.TriangleMesh;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Triangles, alone and in meshes that must not leak. */
final class TriangleTrials {
    private static final Pattern RADIUS = Pattern.compile("r=([0-9.eE+-]+)");
    private static final int MOST_CROSSINGS = 1000;

    private TriangleTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "ray_triangle",
                "A TriangleMesh of that triangle alone; u and v are the weights of its second and third vertex.",
                TriangleTrials::triangle);
        operations.add(
                "watertight",
                "A TriangleMesh of the icosphere, which is itself checked. A third of the rays is aimed at vertices, a third at the"
                        + " middles of edges, a third anywhere. A ray that meets nothing is a miss. Every ray is followed out, leaving"
                        + " each hit as paths do, which tells the sides of an edge apart: the surface must be met from behind and"
                        + " from in front by turns and from behind last, or the parity is even.",
                TriangleTrials::watertight);
    }

    private static void triangle(NumericCase asked, Checks checks) {
        double[] vertices = new double[9];
        double size = 0;
        for (int corner = 0; corner < 3; corner++) {
            double[] vertex = asked.inputs().vector("v" + corner);
            System.arraycopy(vertex, 0, vertices, 3 * corner, 3);
            for (int axis = 0; axis < 3; axis++) {
                size = Math.max(size, Math.abs(vertex[axis] - vertices[axis]));
            }
        }
        TriangleMesh mesh = new TriangleMesh(new MeshData(vertices, new int[] {0, 1, 2}, null, null), false);
        Ray ray = new Ray();
        ray.set(RootTrials.vector(asked.inputs(), "origin"), RootTrials.vector(asked.inputs(), "dir"));
        boolean hit = mesh.intersect(ray);
        checks.same("hit", asked.expected().flag("hit"), hit);
        if (!hit || !asked.expected().has("t")) {
            return;
        }
        checks.size(size).number("t", ray.tMax);
        if (asked.expected().has("u")) {
            checks.size(1).number("u", ray.hitU).number("v", ray.hitV);
        }
    }

    private static void watertight(NumericCase asked, Checks checks) {
        Icosphere sphere = new Icosphere((int) asked.inputs().integer("subdivision"));
        checks.same("triangles", asked.expected().integer("triangles"), (long) sphere.triangleCount());
        checks.same("vertices", asked.expected().integer("vertices"), (long) sphere.vertexCount());
        checks.same("euler", asked.expected().integer("euler"), (long) sphere.eulerCharacteristic());
        SampleStream random = new SampleStream();
        random.start(asked.inputs().integer("seed"), 0, 0);
        Vector3 centre = RootTrials.vector(asked.inputs(), "center");
        double radius = radius(asked.inputs().text("mesh"), 2);
        double reach = radius(asked.inputs().text("origins"), 0.5);
        MeshData data = sphere.data(centre, radius, 0.5, random);
        Leaks leaks = new Leaks(data);
        long rays = asked.inputs().integer("rays");
        for (long i = 0; i < rays; i++) {
            double far = reach * Math.cbrt(random.nextDouble());
            Vector3 origin = centre.plus(DepartureTrials.random(random).times(far));
            Vector3 target = switch ((int) (i % 3)) {
                case 0 -> leaks.vertex(random);
                case 1 -> leaks.middleOfEdge(random);
                default -> origin.plus(DepartureTrials.random(random));
            };
            leaks.follow(origin, target.minus(origin).normalized());
        }
        checks.holds("the mesh is closed", leaks.mesh.isClosed());
        checks.same("misses", asked.expected().integer("misses"), leaks.misses);
        String parity = "even_parity_from_inside_after_merging_equal_t";
        if (asked.expected().has(parity)) {
            checks.same(parity, asked.expected().integer(parity), leaks.even);
        }
    }

    private static double radius(String text, double otherwise) {
        Matcher radius = RADIUS.matcher(text);
        return radius.find() ? Double.parseDouble(radius.group(1)) : otherwise;
    }

    /** Rays from inside a closed mesh, and how many of them did not get out as they should. */
    private static final class Leaks {
        private final MeshData data;
        private final TriangleMesh mesh;
        private final Ray ray = new Ray();
        private final Hit hit = new Hit();
        private long misses;
        private long even;

        Leaks(MeshData data) {
            this.data = data;
            this.mesh = new TriangleMesh(data, false);
        }

        Vector3 vertex(SampleStream random) {
            return vertex((int) (random.nextDouble() * data.vertexCount()));
        }

        Vector3 middleOfEdge(SampleStream random) {
            int corner = (int) (random.nextDouble() * data.triangles().length);
            int next = corner % 3 == 2 ? corner - 2 : corner + 1;
            return vertex(data.triangles()[corner])
                    .plus(vertex(data.triangles()[next]))
                    .times(0.5);
        }

        private Vector3 vertex(int number) {
            return new Vector3(
                    data.vertices()[3 * number], data.vertices()[3 * number + 1], data.vertices()[3 * number + 2]);
        }

        void follow(Vector3 origin, Vector3 direction) {
            ray.set(origin, direction);
            boolean inside = true;
            int crossings = 0;
            while (crossings < MOST_CROSSINGS && mesh.intersect(ray)) {
                hit.take(ray);
                mesh.complete(ray, hit);
                double cosine = direction.x() * hit.normalX + direction.y() * hit.normalY + direction.z() * hit.normalZ;
                // Met from the side on which the ray is not: then it is in glass where it should be in air.
                if (cosine > 0 != inside) {
                    even++;
                    return;
                }
                inside = !inside;
                crossings++;
                LineRoots.leave(ray, hit, direction);
            }
            if (crossings == 0) {
                misses++;
            }
            even += inside ? 1 : 0;
        }
    }
}
