package org.diacaustic.preprocess;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Vector3;

/**
 * A part of space at which light rays are aimed, and the objects that a ray through it counts for: those that it must meet
 * first. Each specular object belongs to one window of a light, so nothing is emitted twice where windows overlap.
 *
 * @param objects numbers of the objects
 * @param bounds that hold them; not finite if they have none
 */
record EmissionWindow(BitSet objects, Bounds bounds) {

    boolean owns(int object) {
        return objects.get(object);
    }

    EmissionWindow union(EmissionWindow other) {
        BitSet both = (BitSet) objects.clone();
        both.or(other.objects);
        return new EmissionWindow(both, bounds.union(other.bounds));
    }

    List<Vector3> corners() {
        List<Vector3> corners = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            corners.add(new Vector3(
                    (i & 1) == 0 ? bounds.minX() : bounds.maxX(),
                    (i & 2) == 0 ? bounds.minY() : bounds.maxY(),
                    (i & 4) == 0 ? bounds.minZ() : bounds.maxZ()));
        }
        return corners;
    }

    /** The area of the rectangle across a direction that the box fits in. */
    double areaAcross(Vector3 direction) {
        Vector3 u = View.uprightAcross(direction);
        Vector3 v = direction.cross(u);
        return 4 * halfExtent(u) * halfExtent(v);
    }

    /** How far the box reaches from its middle along a direction. */
    double halfExtent(Vector3 direction) {
        Vector3 centre = bounds.centre();
        return corners().stream()
                .mapToDouble(corner -> Math.abs(corner.minus(centre).dot(direction)))
                .max()
                .orElse(0);
    }
}
