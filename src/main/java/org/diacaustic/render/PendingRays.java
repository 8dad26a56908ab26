package org.diacaustic.render;

import java.util.Arrays;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.scene.MediumStack;
import org.diacaustic.scene.SceneIndex;

/**
 * The rays of one eye ray's tree that are still to be followed, last in first out. It takes the place of recursion, so
 * that no depth can overflow the thread's stack: two mirrors that face each other keep one ray here.
 */
final class PendingRays {
    private static final int VALUES = 10;

    private final SceneIndex scene;
    private int count;
    private double[] values = new double[0];
    private int[] depth = new int[0];
    private int[] object = new int[0];
    private int[] primitive = new int[0];
    private MediumStack[] media = new MediumStack[0];

    PendingRays(SceneIndex scene) {
        this.scene = scene;
    }

    boolean isEmpty() {
        return count == 0;
    }

    void clear() {
        count = 0;
    }

    /**
     * Adds a ray.
     *
     * @param throughput the fraction of the radiance it finds that reaches the eye
     * @param fromObject the object whose surface it leaves, or none
     * @return the media the ray is in, for the caller to fill
     */
    MediumStack push(
            double ox,
            double oy,
            double oz,
            double dx,
            double dy,
            double dz,
            Rgb throughput,
            int bounces,
            int fromObject,
            int fromPrimitive,
            double departureError) {
        if (count == depth.length) {
            grow();
        }
        int at = count * VALUES;
        values[at] = ox;
        values[at + 1] = oy;
        values[at + 2] = oz;
        values[at + 3] = dx;
        values[at + 4] = dy;
        values[at + 5] = dz;
        values[at + 6] = throughput.red;
        values[at + 7] = throughput.green;
        values[at + 8] = throughput.blue;
        values[at + 9] = departureError;
        depth[count] = bounces;
        object[count] = fromObject;
        primitive[count] = fromPrimitive;
        return media[count++];
    }

    /** Takes the last ray; the rest of it is read by the methods below, until the next push. */
    void pop(Ray ray, Rgb throughput, MediumStack around) {
        count--;
        int at = count * VALUES;
        ray.set(values[at], values[at + 1], values[at + 2], values[at + 3], values[at + 4], values[at + 5]);
        throughput.set(values[at + 6], values[at + 7], values[at + 8]);
        ray.departureError = values[at + 9];
        around.copyFrom(media[count]);
    }

    int depth() {
        return depth[count];
    }

    int object() {
        return object[count];
    }

    int primitive() {
        return primitive[count];
    }

    private void grow() {
        int size = Math.max(16, 2 * count);
        values = Arrays.copyOf(values, size * VALUES);
        depth = Arrays.copyOf(depth, size);
        object = Arrays.copyOf(object, size);
        primitive = Arrays.copyOf(primitive, size);
        media = Arrays.copyOf(media, size);
        for (int i = count; i < size; i++) {
            media[i] = new MediumStack(scene);
        }
    }
}
