package org.diacaustic.scene;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.diacaustic.index.BoxHierarchy;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;

/**
 * The objects of a scene arranged so that rays find them: asked one after the other in list order where they are few, or
 * through a hierarchy of boxes. Immutable and shared by threads.
 *
 * <p>Of several objects at the same distance the first of the list is found, whatever the arrangement.
 */
public final class SceneIndex {
    /** The answer where there is no object, and the object of a ray that leaves none. */
    public static final int NONE = -1;

    /** Up to this many objects a list is no slower than a tree. */
    private static final int FEW = 6;

    private final SceneObject[] objects;
    private final boolean[] opaque;
    /** Objects that are asked one by one: all of them, or those without finite bounds. */
    private final int[] listed;
    /** The same objects in the order in which visitors see them. */
    private final int[] visited;
    /** The objects in the order of the tree's slots. */
    private final int[] treed;

    private final BoxHierarchy tree;

    private SceneIndex(SceneObject[] objects, int[] listed, int[] bounded, boolean listOrder) {
        this.objects = objects;
        this.listed = listed;
        this.opaque = new boolean[objects.length];
        for (int i = 0; i < objects.length; i++) {
            opaque[i] = objects[i].isOpaque();
        }
        visited = listOrder ? listed : opaqueFirst(listed);
        if (bounded.length == 0) {
            tree = null;
            treed = bounded;
        } else {
            double[] boxes = new double[6 * bounded.length];
            for (int i = 0; i < bounded.length; i++) {
                Bounds box = objects[bounded[i]].shape().bounds();
                double[] sides = {box.minX(), box.minY(), box.minZ(), box.maxX(), box.maxY(), box.maxZ()};
                System.arraycopy(sides, 0, boxes, 6 * i, 6);
            }
            tree = BoxHierarchy.over(boxes);
            treed = new int[bounded.length];
            for (int slot = 0; slot < treed.length; slot++) {
                treed[slot] = bounded[tree.item(slot)];
            }
        }
    }

    /** @param listOrder whether every ray asks every object in list order, as the thesis did */
    public static SceneIndex of(List<SceneObject> objects, boolean listOrder) {
        SceneObject[] array = objects.toArray(SceneObject[]::new);
        int[] all = IntStream.range(0, array.length).toArray();
        if (listOrder || array.length <= FEW) {
            return new SceneIndex(array, all, new int[0], listOrder);
        }
        int[] bounded = Arrays.stream(all)
                .filter(i -> array[i].shape().bounds().isFinite())
                .toArray();
        int[] unbounded = Arrays.stream(all)
                .filter(i -> !array[i].shape().bounds().isFinite())
                .toArray();
        return new SceneIndex(array, unbounded, bounded, false);
    }

    /** Whoever looks for what stops light finds it sooner among the opaque objects [Thesis 5.3]. */
    private int[] opaqueFirst(int[] numbers) {
        IntStream stopping = Arrays.stream(numbers).filter(i -> opaque[i]);
        IntStream others = Arrays.stream(numbers).filter(i -> !opaque[i]);
        return IntStream.concat(stopping, others).toArray();
    }

    public boolean hasTree() {
        return tree != null;
    }

    public int size() {
        return objects.length;
    }

    public SceneObject object(int index) {
        return objects[index];
    }

    public boolean isOpaque(int index) {
        return opaque[index];
    }

    /**
     * The object that the ray meets first, or {@link #NONE}; {@code ray.tMax} and the notes then belong to it.
     *
     * @param leavingObject the object whose surface the ray starts on, or {@link #NONE}
     * @param leavingPrimitive the primitive of that object
     */
    public int nearest(Ray ray, int leavingObject, int leavingPrimitive) {
        int nearest = NONE;
        for (int object : listed) {
            ray.leaving = object == leavingObject ? leavingPrimitive : Ray.FREE;
            if (objects[object].shape().intersect(ray)) {
                nearest = object;
            }
        }
        if (tree != null) {
            ray.leaving = leavingObject == NONE ? Ray.FREE : leavingPrimitive;
            int base = tree.enter(ray);
            for (int leaf = tree.next(ray, base); leaf != BoxHierarchy.DONE; leaf = tree.next(ray, base)) {
                int end = BoxHierarchy.end(leaf);
                for (int slot = BoxHierarchy.first(leaf); slot < end; slot++) {
                    int object = treed[slot];
                    ray.leaving = object == leavingObject ? leavingPrimitive : Ray.FREE;
                    if (isNearer(ray, object, nearest)) {
                        nearest = object;
                    }
                }
            }
        }
        return nearest;
    }

    /** Whether the object is hit before the nearest so far, or at the same distance and comes first in the list. */
    private boolean isNearer(Ray ray, int object, int nearest) {
        double limit = ray.tMax;
        if (object < nearest) {
            ray.tMax = Math.nextUp(limit);
        }
        if (objects[object].shape().intersect(ray)) {
            return true;
        }
        ray.tMax = limit;
        return false;
    }

    /**
     * Visits the objects that may lie on the ray until the visitor has seen enough: in list order if that was asked
     * for.
     *
     * @return whether the visitor stopped
     */
    public boolean visit(Ray ray, int leavingObject, int leavingPrimitive, Visitor visitor) {
        for (int object : visited) {
            ray.leaving = object == leavingObject ? leavingPrimitive : Ray.FREE;
            if (visitor.stopsAt(object, ray)) {
                return true;
            }
        }
        if (tree == null) {
            return false;
        }
        ray.leaving = leavingObject == NONE ? Ray.FREE : leavingPrimitive;
        int base = tree.enter(ray);
        for (int leaf = tree.next(ray, base); leaf != BoxHierarchy.DONE; leaf = tree.next(ray, base)) {
            int end = BoxHierarchy.end(leaf);
            for (int slot = BoxHierarchy.first(leaf); slot < end; slot++) {
                int object = treed[slot];
                ray.leaving = object == leavingObject ? leavingPrimitive : Ray.FREE;
                if (visitor.stopsAt(object, ray)) {
                    tree.leave(ray, base);
                    return true;
                }
            }
        }
        return false;
    }

    /** Is asked about each object that may lie on a ray. */
    public interface Visitor {

        /** Returns true to end the visit. {@code ray.leaving} is set for the object; {@code ray.tMax} must not grow. */
        boolean stopsAt(int object, Ray ray);
    }
}
