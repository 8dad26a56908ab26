package org.diacaustic.trial;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.material.Medium;
import org.diacaustic.material.ScatterRules;
import org.diacaustic.material.TransportMode;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.scene.MediumLocator;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.transport.PathRules;
import org.diacaustic.transport.PathTracer;

/** Follows one ray as both passes do, straight on or refracted but never mirrored, and writes down what it meets. */
final class PathRecord extends PathTracer {
    /**
     * A surface that the path came to.
     *
     * @param object by its number in the list
     * @param side 1 if the path came from where the normal points, −1 from behind
     * @param length of the path so far
     * @param arriving the fraction of what started that arrives there
     * @param reflectance of the surface there
     * @param isTotal whether all is reflected
     * @param indexBefore the index of refraction on the side where the path arrives
     */
    record Event(
            int object,
            int side,
            Vector3 point,
            double length,
            double arriving,
            double reflectance,
            boolean isTotal,
            double indexBefore) {

        boolean isEntering() {
            return side > 0;
        }
    }

    private static final int DEEPEST = 1 << 20;

    private final SceneIndex scene;
    private final List<Event> events = new ArrayList<>();
    private Vector3 lastDirection = Vector3.ZERO;
    private double left = Double.NaN;
    private boolean endsInVacuum;

    private PathRecord(SceneIndex scene, PathRules rules) {
        super(scene, rules);
        this.scene = scene;
    }

    /**
     * The path of one ray, which starts in the media that are found around its start.
     *
     * @param direction of any length but 0
     * @param most surfaces that it may go through
     */
    static PathRecord of(
            List<SceneObject> objects, ScatterRules scattering, int most, Vector3 origin, Vector3 direction) {
        SceneIndex scene = SceneIndex.of(objects, false);
        PathRecord path = new PathRecord(scene, new PathRules(scattering, TransportMode.FLUX, most, 0, false, false));
        path.ray.set(origin, direction.normalized());
        path.followAll(MediumLocator.locate(scene, origin), new StopSignal());
        return path;
    }

    /** The path of one ray through as many surfaces as there are. */
    static PathRecord of(List<SceneObject> objects, Vector3 origin, Vector3 direction) {
        return of(objects, ScatterRules.PHYSICAL, DEEPEST, origin, direction);
    }

    @Override
    protected boolean arrive(int object, int side) {
        events.add(new Event(
                object,
                side,
                new Vector3(hit.x, hit.y, hit.z),
                pathLength,
                throughput.green,
                scattering.reflectance.green,
                scattering.totalInternalReflection,
                media.near().indexOfRefraction()));
        return !scene.isOpaque(object);
    }

    @Override
    protected void end() {
        lastDirection = new Vector3(ray.directionX, ray.directionY, ray.directionZ);
        left = throughput.green;
        endsInVacuum =
                media.dominantObject() == SceneIndex.NONE && media.current().equals(Medium.VACUUM);
    }

    @Override
    protected void cut(Rgb fraction) {
        // Mirrored rays: what they carry is not asked about.
    }

    @Override
    protected void spoiled() {
        left = Double.NaN;
    }

    List<Event> events() {
        return events;
    }

    double[] reflectances() {
        return events.stream().mapToDouble(Event::reflectance).toArray();
    }

    /** Whether the path believed to be in nothing at its end. */
    boolean endsInVacuum() {
        return endsInVacuum;
    }

    /** Where the path goes after the last surface; zero if it never leaves. */
    Vector3 lastDirection() {
        return lastDirection;
    }

    /** The fraction of what started that leaves; not a number if none does. */
    double left() {
        return left;
    }
}
