package org.diacaustic.study;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.diacaustic.json.JsonWriter;
import org.snakeyaml.engine.v2.api.Load;
import org.snakeyaml.engine.v2.api.LoadSettings;

/** What a study keeps, as JSON, and back again: every double to its last bit. */
final class KeptJson {
    private static final String SETTINGS = "settings";

    private KeptJson() {}

    static String of(Map<String, String> texts) {
        JsonWriter json = new JsonWriter().beginObject();
        texts.forEach(json::put);
        return json.end().toString();
    }

    static Map<String, String> texts(String text) {
        Map<String, String> texts = new LinkedHashMap<>();
        try {
            read(text).forEach((key, value) -> texts.put(key.toString(), String.valueOf(value)));
        } catch (RuntimeException cutShort) {
            // Whatever it said, it was not this.
            texts.clear();
        }
        return texts;
    }

    static String of(Reference reference) {
        JsonWriter json = new JsonWriter().beginObject();
        json.put("origin", reference.origin().name());
        json.put("rays", reference.rays());
        json.put("batches", reference.batches());
        json.put("seconds", reference.seconds());
        return json.end().toString();
    }

    /** The pictures of a reference that was read, with the facts that were kept beside them; nothing if those cannot be read. */
    static Optional<Reference> withFacts(Reference pictures, String text) {
        try {
            return Optional.of(withFacts(pictures, read(text)));
        } catch (RuntimeException cutShort) {
            // As good as none.
            return Optional.empty();
        }
    }

    private static Reference withFacts(Reference pictures, Map<?, ?> facts) {
        return new Reference(
                Reference.Origin.valueOf(facts.get("origin").toString()),
                pictures.picture(),
                pictures.standardError(),
                pictures.halves(),
                ((Number) facts.get("rays")).longValue(),
                ((Number) facts.get("batches")).intValue(),
                number(facts.get("seconds")));
    }

    /** A point, with all that its technique laid over the scene's settings. */
    static String of(Technique technique, StudyPoint point) {
        JsonWriter json = new JsonWriter().beginObject();
        json.put(SETTINGS, settings(technique));
        write(point, json);
        return json.end().toString();
    }

    /** Writes the members of a point into an object that is open. */
    static void write(StudyPoint point, JsonWriter json) {
        json.put("budget", point.budget().label());
        json.put("rays", point.rays());
        json.put("passes", point.passes());
        json.put("squaredBias", point.squaredBias());
        json.put("variance", point.variance());
        json.put("referenceError", point.referenceError());
        json.name("runs").beginArray();
        for (StudyRun run : point.runs()) {
            json.beginObject();
            json.put("seed", run.seed());
            run.values().forEach((measure, value) -> json.put(measure.key(), value));
            json.end();
        }
        json.end();
    }

    /** The point; nothing if the technique had other settings then, or it cannot be read. */
    static Optional<StudyPoint> point(Technique technique, Budget budget, String text) {
        try {
            Map<?, ?> members = read(text);
            return settings(technique).equals(members.get(SETTINGS))
                    ? Optional.of(point(budget, members))
                    : Optional.empty();
        } catch (RuntimeException cutShort) {
            // As good as none.
            return Optional.empty();
        }
    }

    private static String settings(Technique technique) {
        return technique.way() + ", " + technique.raysAPass() + " rays a pass, " + new TreeMap<>(technique.overrides());
    }

    private static StudyPoint point(Budget budget, Map<?, ?> members) {
        List<StudyRun> runs = new ArrayList<>();
        for (Object run : (List<?>) members.get("runs")) {
            Map<?, ?> values = (Map<?, ?>) run;
            Map<Measure, Double> measured = new EnumMap<>(Measure.class);
            for (Measure measure : Measure.values()) {
                measured.put(measure, number(values.get(measure.key())));
            }
            runs.add(new StudyRun(((Number) values.get("seed")).longValue(), measured));
        }
        return new StudyPoint(
                budget,
                ((Number) members.get("rays")).longValue(),
                ((Number) members.get("passes")).intValue(),
                number(members.get("squaredBias")),
                number(members.get("variance")),
                number(members.get("referenceError")),
                runs);
    }

    private static Map<?, ?> read(String text) {
        return (Map<?, ?>) new Load(LoadSettings.builder().build()).loadFromString(text);
    }

    /** JSON has no word for what is not a number. */
    private static double number(Object value) {
        return value == null ? Double.NaN : ((Number) value).doubleValue();
    }
}
