package org.diacaustic.trial;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.diacaustic.material.Material;
import org.diacaustic.math.Color;
import org.diacaustic.math.Ray;
import org.diacaustic.math.SampleStream;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Rays that start on a surface, or next to one. */
final class DepartureTrials {
    private static final long SEED = 1;
    private static final Pattern GAP = Pattern.compile("lost_second_surface_hits_gap_(.+)");
    private static final Pattern HITS = Pattern.compile("(\\d+)(?:\\^(\\d+))? hits");

    private DepartureTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "ray_plane",
                "A Plane asked by a ray in free space. There is no smallest distance.",
                DepartureTrials::plane);
        operations.add(
                "spawn_plane",
                "A Plane with another on each side of it at the gap that the case names, arranged by SceneIndex. Rays as the case says"
                        + " hit it; from each completed hit as many rays leave in random directions (seed 1), half to either side. A"
                        + " self hit: it finds the plane that it leaves. Lost: it does not find the plane on its side.",
                DepartureTrials::leavePlane);
        operations.add(
                "spawn_sphere_chord",
                "1000 random rays (seed 1) hit a Sphere; from each completed hit one ray leaves inward at that angle to the normal, whose"
                        + " length to the next hit is the chord, and 100 leave outward, at angles of all sizes, that must"
                        + " find nothing.",
                DepartureTrials::leaveSphere);
    }

    private static void plane(NumericCase asked, Checks checks) {
        Plane plane = new Plane(
                RootTrials.vector(asked.inputs(), "plane_point"), RootTrials.vector(asked.inputs(), "plane_normal"));
        Ray ray = new Ray();
        ray.set(RootTrials.vector(asked.inputs(), "origin"), RootTrials.vector(asked.inputs(), "dir"));
        boolean hit = plane.intersect(ray);
        checks.same("hit", asked.expected().flag("hit"), hit);
        if (asked.expected().has("t")) {
            checks.number("t", ray.tMax);
        }
    }

    private static void leavePlane(NumericCase asked, Checks checks) {
        Vector3 point = RootTrials.vector(asked.inputs(), "plane_point");
        Vector3 normal = RootTrials.vector(asked.inputs(), "plane_normal").normalized();
        String lostName = asked.expected().keys().stream()
                .filter(key -> GAP.matcher(key).matches())
                .findFirst()
                .orElseThrow(() -> new CaseFault("the case does not name the gap to the second surface"));
        Matcher gap = GAP.matcher(lostName);
        gap.matches();
        Vector3 beside = normal.times(Double.parseDouble(gap.group(1)));
        SceneIndex scene = SceneIndex.of(
                List.of(
                        object(new Plane(point, normal)),
                        object(new Plane(point.plus(beside), normal)),
                        object(new Plane(point.minus(beside), normal))),
                false);
        int hits = count(asked.inputs().text("hit_points"));
        int each = (int) Math.max(1, asked.inputs().integer("directions") / hits);
        SampleStream random = new SampleStream();
        random.start(SEED, 0, 0);
        Ray ray = new Ray();
        Hit hit = new Hit();
        long selfHits = 0;
        long lost = 0;
        for (int i = 0; i < hits; i++) {
            Vector3 target = point.plus(new Vector3(spread(random), spread(random), spread(random)).times(3));
            Vector3 eye = new Vector3(point.x(), point.y() + 5, point.z() + 5);
            arrive(
                    ray,
                    hit,
                    scene,
                    eye,
                    target.minus(normal.times(target.minus(point).dot(normal))));
            for (int k = 0; k < each; k++) {
                Vector3 way = random(random);
                LineRoots.leave(ray, hit, way);
                int found = scene.nearest(ray, 0, hit.primitive);
                selfHits += found == 0 ? 1 : 0;
                lost += found != (way.dot(normal) > 0 ? 1 : 2) ? 1 : 0;
            }
        }
        checks.same("self_hits", asked.expected().integer("self_hits"), selfHits);
        checks.same(lostName, asked.expected().integer(lostName), lost);
    }

    /** Completes the hit of a ray on object 0, whatever lies before it. */
    private static void arrive(Ray ray, Hit hit, SceneIndex scene, Vector3 from, Vector3 to) {
        ray.set(from, to.minus(from).normalized());
        if (!scene.object(0).shape().intersect(ray)) {
            throw new CaseFault("the rays that the case describes do not meet its plane");
        }
        hit.take(ray);
        scene.object(0).shape().complete(ray, hit);
    }

    private static void leaveSphere(NumericCase asked, Checks checks) {
        double radius = asked.inputs().number("radius");
        double angle = StrictMath.toRadians(asked.inputs().number("angle_deg"));
        Vector3 centre = asked.inputs().has("center") ? RootTrials.vector(asked.inputs(), "center") : Vector3.ZERO;
        SceneIndex scene = SceneIndex.of(List.of(object(new Sphere(centre, radius))), false);
        SampleStream random = new SampleStream();
        random.start(SEED, 0, 0);
        Ray ray = new Ray();
        Hit hit = new Hit();
        double worst = asked.expected().number("chord");
        long selfHits = 0;
        for (int i = 0; i < 1000; i++) {
            Vector3 from = centre.plus(random(random).times(3 * radius));
            arrive(ray, hit, scene, from, centre.plus(random(random).times(0.9 * radius)));
            Vector3 normal = new Vector3(hit.normalX, hit.normalY, hit.normalZ);
            Vector3 aside = normal.cross(random(random)).normalized();
            LineRoots.leave(ray, hit, tilted(normal, aside, Math.PI - angle));
            double chord = scene.nearest(ray, 0, hit.primitive) == 0 ? ray.tMax : 0;
            double exact = asked.expected().number("chord");
            worst = Math.abs(chord - exact) <= Math.abs(worst - exact) ? worst : chord;
            for (int k = 0; k < 100; k++) {
                // As many in each power of ten of the angle to the surface.
                double flat = Math.PI / 2 * StrictMath.pow(10, -15 * random.nextDouble());
                LineRoots.leave(ray, hit, tilted(normal, aside, Math.PI / 2 - flat));
                selfHits += scene.nearest(ray, 0, hit.primitive) == 0 ? 1 : 0;
            }
        }
        checks.size(radius);
        checks.number("chord", worst);
        checks.same("outward_self_hits", asked.expected().integer("outward_self_hits"), selfHits);
    }

    private static Vector3 tilted(Vector3 normal, Vector3 aside, double angle) {
        return normal.times(StrictMath.cos(angle)).plus(aside.times(StrictMath.sin(angle)));
    }

    private static SceneObject object(Shape shape) {
        return new SceneObject(
                "surface", shape, Material.builder().diffuse(Color.WHITE).build());
    }

    /** The number in a text such as "10^3 hits of rays from ...". */
    private static int count(String text) {
        Matcher hits = HITS.matcher(text);
        if (!hits.find()) {
            throw new CaseFault("the case should say how many hits there are, such as 10^3 hits, but says: " + text);
        }
        double power = hits.group(2) == null ? 1 : Double.parseDouble(hits.group(2));
        return (int) Math.pow(Double.parseDouble(hits.group(1)), power);
    }

    private static double spread(SampleStream random) {
        return 2 * random.nextDouble() - 1;
    }

    /** A direction, evenly distributed. */
    static Vector3 random(SampleStream random) {
        double z = spread(random);
        double around = 2 * Math.PI * random.nextDouble();
        double ring = Math.sqrt((1 - z) * (1 + z));
        return new Vector3(ring * StrictMath.cos(around), ring * StrictMath.sin(around), z).normalized();
    }
}
