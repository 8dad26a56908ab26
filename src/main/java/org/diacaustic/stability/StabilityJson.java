package org.diacaustic.stability;

import org.diacaustic.json.JsonWriter;

/** A report as JSON. What is endless or not a number is null there, as JSON has no word for it. */
final class StabilityJson {
    private StabilityJson() {}

    static String of(StabilityReport report) {
        JsonWriter json = new JsonWriter().beginObject();
        json.put("java", System.getProperty("java.runtime.version"));
        json.put("seconds", report.seconds());
        json.name("categories").beginArray();
        report.categories().forEach(category -> write(category, json));
        json.end();
        json.name("cases").beginArray();
        report.results().forEach(result -> write(result, json));
        json.end();
        return json.end().toString();
    }

    private static void write(CategorySummary category, JsonWriter json) {
        json.beginObject();
        json.put("category", category.category());
        json.put("cases", category.cases());
        for (Verdict verdict : Verdict.values()) {
            json.put(verdict.toString(), category.count(verdict));
        }
        json.put("medianErrorOverTolerance", category.medianRatio());
        category.worst().ifPresent(worst -> {
            json.put("worst", worst.asked().id());
            json.put("worstErrorOverTolerance", worst.ratio());
        });
        json.end();
    }

    private static void write(CaseResult result, JsonWriter json) {
        json.beginObject();
        json.put("id", result.asked().id());
        json.put("category", result.asked().category());
        json.put("title", result.asked().title());
        json.put("operation", result.asked().operation());
        json.put("verdict", result.verdict().toString());
        if (!result.reason().isEmpty()) {
            json.put("reason", result.reason());
        }
        json.put("errorOverTolerance", result.ratio());
        json.put("seconds", result.seconds());
        json.name("checks").beginArray();
        for (Check check : result.checks()) {
            json.beginObject();
            json.put("what", check.what());
            json.put("expected", check.expected());
            json.put("got", check.got());
            json.put("error", check.error());
            json.put("tolerance", check.tolerance().pass());
            if (check.isStretched()) {
                json.put("stretchTolerance", check.tolerance().stretch());
            }
            json.put("verdict", check.verdict().toString());
            json.end();
        }
        json.end();
        json.name("notes").beginArray();
        result.notes().forEach(json::value);
        json.end();
        json.end();
    }
}
