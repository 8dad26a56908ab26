package org.diacaustic.scene;

import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;

/**
 * The media that a ray is in: the closed transparent objects it has entered and not left, above the medium that open
 * surfaces last put it in. Mutable, owned by one task; a copy goes along with every ray.
 *
 * <p>A closed object is entered and left by identity, so overlaps may come in any order. Where objects overlap, the highest
 * priority fills the space, among equals the one entered last; a boundary inside something that dominates it is
 * invisible. An open surface declares the medium on each of its sides, and the side that the ray arrives on decides,
 * whatever was believed before. What it declares gives way to closed objects of at least the same priority: inside one
 * that dominates both of its sides the surface is invisible and only changes what is around.
 */
public final class MediumStack {
    private static final int BASE = -1;

    private final SceneIndex scene;
    private Medium base = Medium.VACUUM;
    private int[] entered = new int[8];
    private int count;

    private Medium near = Medium.VACUUM;
    private Medium far = Medium.VACUUM;
    private boolean visible;

    public MediumStack(SceneIndex scene) {
        this.scene = scene;
    }

    public void copyFrom(MediumStack other) {
        base = other.base;
        if (entered.length < other.count) {
            entered = new int[other.entered.length];
        }
        System.arraycopy(other.entered, 0, entered, 0, other.count);
        count = other.count;
    }

    /** The medium that fills the space where the ray is. */
    public Medium current() {
        return medium(dominant(count, BASE));
    }

    /** The closed object that fills the space where the ray is; none if that is what open surfaces or nothing fill. */
    public int dominantObject() {
        return dominant(count, BASE);
    }

    /**
     * Whether the ray can be about to cross a boundary, as far as is known: it cannot enter what it is in, nor leave what
     * it is not in. Where surfaces touch, this tells those that are still ahead from those that were crossed just now.
     */
    public boolean canCross(int object, boolean entering) {
        if (scene.object(object).shape().isClosed()) {
            return entering == (lastIndexOf(object) == BASE);
        }
        Medium before = side(object, !entering);
        Medium after = side(object, entering);
        return before.equals(after) || !base.equals(after);
    }

    /**
     * Looks at the boundary of an object without crossing it: sets {@link #near()}, {@link #far()} and
     * {@link #isVisible()}.
     *
     * @param entering whether the ray goes from the outside, where the normal points, to the inside
     */
    public void lookAt(int object, boolean entering) {
        if (scene.object(object).shape().isClosed()) {
            lookAtClosed(object, entering);
        } else {
            lookAtSheet(object, entering);
        }
    }

    private void lookAtClosed(int object, boolean entering) {
        int at = lastIndexOf(object);
        int before;
        int after;
        if (entering) {
            before = dominant(count, BASE);
            push(object);
            after = dominant(count, BASE);
            count--;
        } else {
            boolean believedOutside = at == BASE;
            if (believedOutside) {
                push(object);
                at = count - 1;
            }
            before = dominant(count, BASE);
            after = dominant(count, at);
            if (believedOutside) {
                count--;
            }
        }
        near = medium(before);
        far = medium(after);
        visible = before == object || after == object;
    }

    private void lookAtSheet(int object, boolean entering) {
        base = side(object, !entering);
        int before = dominant(count, BASE);
        near = medium(before);
        base = side(object, entering);
        int after = dominant(count, BASE);
        far = medium(after);
        base = side(object, !entering);
        visible = before == BASE || after == BASE;
    }

    /** Goes through the boundary of an object. */
    public void cross(int object, boolean entering) {
        if (!scene.object(object).shape().isClosed()) {
            base = side(object, entering);
            return;
        }
        if (entering) {
            push(object);
            return;
        }
        int at = lastIndexOf(object);
        if (at != BASE) {
            System.arraycopy(entered, at + 1, entered, at, count - at - 1);
            count--;
        }
    }

    /** Puts the ray into a medium that no closed object fills. */
    public void setBase(Medium medium) {
        base = medium;
    }

    /** The medium on the side where the ray arrives. */
    public Medium near() {
        return near;
    }

    /** The medium on the other side. */
    public Medium far() {
        return far;
    }

    /** Whether the boundary separates anything: if not, the ray goes on as if it were not there. */
    public boolean isVisible() {
        return visible;
    }

    /** The object that fills the space, of the first {@code size} entered without the one at {@code except}. */
    private int dominant(int size, int except) {
        int best = BASE;
        int highest = base.priority();
        for (int i = 0; i < size; i++) {
            int priority = medium(entered[i]).priority();
            if (i != except && priority >= highest) {
                best = entered[i];
                highest = priority;
            }
        }
        return best;
    }

    /** The medium that an open surface declares behind it, or in front of it. */
    private Medium side(int object, boolean inside) {
        Material material = scene.object(object).material();
        return inside ? material.inside() : material.outside();
    }

    private Medium medium(int object) {
        return object == BASE ? base : scene.object(object).material().inside();
    }

    private void push(int object) {
        if (count == entered.length) {
            entered = java.util.Arrays.copyOf(entered, 2 * count);
        }
        entered[count++] = object;
    }

    private int lastIndexOf(int object) {
        for (int i = count - 1; i >= 0; i--) {
            if (entered[i] == object) {
                return i;
            }
        }
        return BASE;
    }
}
