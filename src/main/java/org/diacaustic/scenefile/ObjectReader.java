package org.diacaustic.scenefile;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.diacaustic.material.Material;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Shape;

/** Reads {@code objects}: a shape each, with a name, a material, and perhaps a place of its own. */
final class ObjectReader {
    /** As for the reach of lookups; the square of a length that is larger may be infinite, and of its inverse 0. */
    private static final double LARGEST = 1e150;

    private final MappingReader root;
    private final Map<String, Material> materials;
    private final Map<String, Place> names = new HashMap<>();
    private final Map<String, Function<MappingReader, SceneObject>> kinds = new LinkedHashMap<>();
    private int number;

    ObjectReader(MappingReader root, Map<String, Material> materials, Problems problems) {
        this.root = root;
        this.materials = materials;
        new ShapeReader(problems).kinds().forEach((kind, shape) -> kinds.put(kind, in -> object(in, kind, shape)));
    }

    List<SceneObject> readAll() {
        List<SceneObject> objects = new ArrayList<>();
        for (Variant variant : root.variants("objects")) {
            number++;
            variant.read(kinds).ifPresent(objects::add);
        }
        return objects;
    }

    private SceneObject object(MappingReader in, String kind, Function<MappingReader, Shape> shapeReader) {
        String name = name(in, kind);
        Material material = material(in);
        Vector3 inside = in.direction("inside").optional().orElse(null);
        Shape placed = ShapeReader.placed(in, shapeReader);
        if (placed == null || material == null) {
            return null;
        }
        requireSize(in, placed);
        return new SceneObject(name, placed, turned(in, placed, material, inside));
    }

    /** Refuses a shape with lengths whose squares are no doubles; what has no end by its nature may have none. */
    private static void requireSize(MappingReader in, Shape shape) {
        Bounds bounds = shape.bounds();
        boolean bounded = !bounds.isEmpty() && (bounds.isFinite() || shape.isClosed());
        double size = bounds.radius();
        double away = bounds.centre().length();
        if (bounded && !(size >= 1 / LARGEST && size <= LARGEST && away <= LARGEST)) {
            in.error("expected a shape with a size from " + 1 / LARGEST + " to " + LARGEST
                    + ", and no farther away, found one of " + size + " at " + bounds.centre());
        }
    }

    private String name(MappingReader in, String kind) {
        String name = in.text("name").or(kind + "-" + number);
        Place first = names.putIfAbsent(name, in.place());
        if (first != null) {
            in.error("name", "another object is named '" + name + "' already, at line " + first.line());
        }
        return name;
    }

    /** The material that is named, or described on the spot. */
    private Material material(MappingReader in) {
        if (in.form("material") == Form.MAPPING) {
            return MaterialReader.read(in.mapping("material"));
        }
        String name = in.text("material").required();
        if (!name.isEmpty() && !materials.containsKey(name)) {
            in.error("material", "there is no material '" + name + "'" + Suggestions.forWord(name, materials.keySet()));
        }
        return materials.get(name);
    }

    /**
     * The material with its media exchanged if the wanted side of an open surface is not the one behind its normal.
     *
     * @param inside roughly the direction in which the inside medium lies; null for behind the normal
     */
    private static Material turned(MappingReader in, Shape shape, Material material, Vector3 inside) {
        if (inside == null) {
            return material;
        }
        if (shape.isClosed()) {
            in.error("inside", "a closed shape has its inside already");
            return material;
        }
        double along = normalAlong(shape, inside.normalized());
        if (along == 0) {
            in.error("inside", "a line along this direction through the middle of the shape must meet it");
            return material;
        }
        return along < 0 ? material : material.withSidesExchanged();
    }

    /** The component of the shape's normal along a direction, where a line along it through its middle meets it; or 0. */
    private static double normalAlong(Shape shape, Vector3 direction) {
        Bounds bounds = shape.bounds();
        Vector3 middle = bounds.isFinite() ? bounds.centre() : Vector3.ZERO;
        Vector3 start = bounds.isFinite() ? middle.minus(direction.times(2 * bounds.radius())) : middle;
        for (Vector3 way : List.of(direction, direction.negated())) {
            Ray ray = new Ray();
            ray.set(start, way);
            if (shape.intersect(ray)) {
                Hit hit = new Hit();
                hit.take(ray);
                shape.complete(ray, hit);
                return direction.dot(new Vector3(hit.normalX, hit.normalY, hit.normalZ));
            }
        }
        return 0;
    }
}
