package org.diacaustic.shape;

import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;

/**
 * A surface that rays can meet. Shapes know nothing of materials or light. An implementation is immutable and may be
 * asked by many threads at once; everything that changes is in the {@link Ray} and the {@link Hit}, which belong to the
 * caller.
 *
 * <p>Intersection has two phases. {@link #intersect} and {@link #occludes} run for every ray and only shorten or answer;
 * {@link #complete} runs once for the nearest hit and computes point and normal with all care.
 *
 * <p><b>Leaving a surface.</b> There is no smallest distance. A ray that starts on a primitive of this shape says so in
 * {@link Ray#leaving}; the shape then leaves out the point where it starts, and only that: a flat primitive is not asked
 * at all, a curved one drops the root that is its start. A shape that cannot tell may use {@link Ray#nearest()} as its
 * smallest t.
 */
public interface Shape {

    /** A box that holds every point of the surface, never too small; {@link Bounds#UNBOUNDED} if there is none. */
    Bounds bounds();

    /**
     * Looks for the first point of this surface with 0 &lt; t &lt; {@code ray.tMax}. If there is one, shortens
     * {@code ray.tMax} to it, notes the primitive ({@link Ray#hit}) and returns true; otherwise leaves the ray as it is.
     */
    boolean intersect(Ray ray);

    /** Whether any point of this surface lies within 0 &lt; t &lt; {@code ray.tMax}; may change what the ray notes. */
    default boolean occludes(Ray ray) {
        return intersect(ray);
    }

    /**
     * Fills in point, error of the point, geometric normal and shading normal of the hit that {@link #intersect} noted in
     * the ray. {@code hit.t}, {@code hit.primitive} and the notes are set already.
     */
    void complete(Ray ray, Hit hit);

    /**
     * Fills in the map coordinates u, v in 0..1 of a completed hit, and the tangents where they are defined: the shape's
     * own inverse mapping [Thesis 2.4].
     */
    void inverseMap(Hit hit);

    /**
     * The number of the smooth piece of the surface that a completed hit lies on: rays that meet one piece side by side
     * are mirrored and refracted side by side. Where pieces meet there are edges, in the form or in the shading.
     */
    default int piece(Hit hit) {
        return hit.primitive;
    }

    /** Whether the surface encloses a volume: a ray that enters it must leave it again. */
    boolean isClosed();
}
