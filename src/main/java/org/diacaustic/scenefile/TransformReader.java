package org.diacaustic.scenefile;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.diacaustic.math.Transform;
import org.diacaustic.math.Vector3;

/** Reads {@code transform}: a list of steps, done in the order in which they stand. */
final class TransformReader {
    private static final Map<String, Function<MappingReader, Transform>> STEPS = new Kinds<
                    Function<MappingReader, Transform>>()
            .with("scale", TransformReader::scale)
            .with("rotate", TransformReader::rotate)
            .with("translate", TransformReader::translate)
            .map();

    private TransformReader() {}

    static Optional<Transform> read(MappingReader in) {
        List<Variant> steps = in.variants("transform");
        if (steps.isEmpty()) {
            return Optional.empty();
        }
        Transform whole = Transform.identity();
        for (Variant step : steps) {
            whole = whole.then(step.read(STEPS).orElse(Transform.identity()));
        }
        return Optional.of(whole);
    }

    private static Transform scale(MappingReader in) {
        Vector3 by = in.vector3("by").required();
        return Building.of(in, () -> Transform.identity().scale(by.x(), by.y(), by.z()));
    }

    private static Transform rotate(MappingReader in) {
        Vector3 axis = in.direction("axis").required();
        double angle = in.number("angle").in("degrees").required();
        return Building.of(in, () -> Transform.identity().rotate(axis, angle));
    }

    private static Transform translate(MappingReader in) {
        Vector3 by = in.vector3("by").required();
        return Building.of(in, () -> Transform.identity().translate(by));
    }
}
