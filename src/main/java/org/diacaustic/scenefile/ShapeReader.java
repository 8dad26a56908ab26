package org.diacaustic.scenefile;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Transform;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.Combination;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Disc;
import org.diacaustic.shape.Ellipsoid;
import org.diacaustic.shape.FlakeKind;
import org.diacaustic.shape.Frustum;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Quadric;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;
import org.diacaustic.shape.Sphereflake;
import org.diacaustic.shape.Torus;
import org.diacaustic.shape.Transformed;
import org.diacaustic.shape.TriangleMesh;

/** Reads the shapes of objects, each from the keys of its own. */
final class ShapeReader {
    /** Kinds of shapes that enclose nothing. */
    private static final Set<String> FLAT = Set.of("plane", "polygon", "disc");

    private final Problems problems;
    private final Map<String, Function<MappingReader, Shape>> kinds = new Kinds<Function<MappingReader, Shape>>()
            .with("plane", ShapeReader::plane)
            .with("polygon", ShapeReader::polygon)
            .with("sphere", ShapeReader::sphere)
            .with("ellipsoid", ShapeReader::ellipsoid)
            .with("quadric", ShapeReader::quadric)
            .with("box", ShapeReader::box)
            .with("cylinder", ShapeReader::cylinder)
            .with("cone", ShapeReader::cone)
            .with("disc", ShapeReader::disc)
            .with("torus", ShapeReader::torus)
            .with("sphereflake", ShapeReader::sphereflake)
            .with("mesh", this::mesh)
            .with("union", in -> combination(in, Combination.Kind.UNION))
            .with("intersection", in -> combination(in, Combination.Kind.INTERSECTION))
            .with("difference", in -> combination(in, Combination.Kind.DIFFERENCE))
            .map();

    ShapeReader(Problems problems) {
        this.problems = problems;
    }

    /** The readers by kind. Each returns null if anything was wrong, which has been told. */
    Map<String, Function<MappingReader, Shape>> kinds() {
        return kinds;
    }

    private static Shape plane(MappingReader in) {
        Vector3 at = in.vector3("at").required();
        Vector3 normal = in.direction("normal").required();
        return Building.of(in, () -> new Plane(at, normal));
    }

    private static Shape polygon(MappingReader in) {
        List<Vector3> vertices = in.points("vertices", 3).required();
        boolean twoSided = in.flag("two-sided").or(true);
        return Building.of(in, () -> {
            Vector3[] corners = vertices.toArray(Vector3[]::new);
            return twoSided ? ConvexPolygon.twoSided(corners) : ConvexPolygon.oneSided(corners);
        });
    }

    private static Shape sphere(MappingReader in) {
        Vector3 at = in.vector3("at").required();
        double radius = in.number("radius").above(0).required();
        return Building.of(in, () -> new Sphere(at, radius));
    }

    private static Shape ellipsoid(MappingReader in) {
        Vector3 at = in.vector3("at").required();
        Vector3 radii = in.vector3("radii").required();
        return Building.of(in, () -> new Ellipsoid(at, radii));
    }

    private static Shape quadric(MappingReader in) {
        double[] coefficients = in.numbers("coefficients", 10).required();
        boolean clipped = in.has("low") || in.has("high");
        Vector3 low = clipped ? in.vector3("low").required() : null;
        Vector3 high = clipped ? in.vector3("high").required() : null;
        return Building.of(in, () -> {
            Quadric whole = Quadric.of(coefficients);
            return clipped ? whole.within(new Bounds(low.x(), low.y(), low.z(), high.x(), high.y(), high.z())) : whole;
        });
    }

    private static Shape box(MappingReader in) {
        Vector3 low = in.vector3("low").required();
        Vector3 high = in.vector3("high").required();
        return Building.of(in, () -> new Box(low, high));
    }

    private static Shape cylinder(MappingReader in) {
        Vector3 from = in.vector3("from").required();
        Vector3 to = in.vector3("to").required();
        double radius = in.number("radius").above(0).required();
        boolean capped = in.flag("capped").or(true);
        return Building.of(in, () -> Frustum.cylinder(from, to, radius, capped));
    }

    /** A cone from its base to its tip, or to a smaller top. */
    private static Shape cone(MappingReader in) {
        Vector3 from = in.vector3("from").required();
        Vector3 to = in.vector3("to").required();
        double radius = in.number("radius").above(0).required();
        double topRadius = in.number("top-radius").atLeast(0).or(0.0);
        boolean capped = in.flag("capped").or(true);
        return Building.of(
                in,
                () -> topRadius == 0
                        ? Frustum.cone(from, radius, to, capped)
                        : Frustum.between(from, radius, to, topRadius, capped));
    }

    private static Shape disc(MappingReader in) {
        Vector3 at = in.vector3("at").required();
        Vector3 normal = in.direction("normal").required();
        double radius = in.number("radius").above(0).required();
        double innerRadius = in.number("inner-radius").atLeast(0).or(0.0);
        return Building.of(in, () -> new Disc(at, normal, innerRadius, radius));
    }

    private static Shape torus(MappingReader in) {
        Vector3 at = in.vector3("at").required();
        Vector3 axis = in.direction("axis").or(Vector3.UNIT_Y);
        double major = in.number("major-radius").above(0).required();
        double minor = in.number("minor-radius").above(0).required();
        return Building.of(in, () -> new Torus(at, axis, major, minor));
    }

    private static Shape sphereflake(MappingReader in) {
        Vector3 at = in.vector3("at").required();
        double radius = in.number("radius").above(0).required();
        FlakeKind kind = in.choice(
                        "children",
                        new Kinds<FlakeKind>()
                                .with("9", FlakeKind.CLASSIC)
                                .with("6", FlakeKind.OCTAHEDRAL)
                                .map())
                .or(FlakeKind.CLASSIC);
        int depth = in.integer("depth").atLeast(0).atMost(8).required();
        double ratio = in.number("ratio").above(0).below(1).or(1.0 / 3);
        Vector3 up = in.direction("up").or(Vector3.UNIT_Y);
        return Building.of(in, () -> new Sphereflake(kind, depth, at, radius, ratio, up, up.perpendicular()));
    }

    private Shape combination(MappingReader in, Combination.Kind kind) {
        Map<String, Function<MappingReader, Shape>> placed = new LinkedHashMap<>();
        kinds.forEach((name, shape) -> {
            if (!FLAT.contains(name)) {
                placed.put(name, part -> placed(part, shape));
            }
        });
        List<Shape> shapes = in.variants("of", 2).stream()
                .map(part -> part.read(placed))
                .flatMap(Optional::stream)
                .toList();
        return Building.of(in, () -> Combination.of(kind, shapes));
    }

    /** A shape with the transform that its keys may hold. */
    static Shape placed(MappingReader in, Function<MappingReader, Shape> reader) {
        Optional<Transform> transform = TransformReader.read(in);
        Shape shape = reader.apply(in);
        return shape == null
                ? null
                : transform.<Shape>map(t -> new Transformed(shape, t)).orElse(shape);
    }

    private Shape mesh(MappingReader in) {
        Path file = in.file("file").required();
        boolean smooth = in.flag("smooth").or(true);
        if (!in.finish() || file.toString().isEmpty()) {
            return null;
        }
        return MeshFile.read(file, problems)
                .map(data -> Building.of(in, () -> new TriangleMesh(data, smooth)))
                .orElse(null);
    }
}
