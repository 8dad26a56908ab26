package org.diacaustic.study;

import java.util.Locale;
import org.diacaustic.json.JsonWriter;

/** A study as JSON. */
final class StudyJson {
    private final StudyReport report;
    private final JsonWriter json = new JsonWriter();

    StudyJson(StudyReport report) {
        this.report = report;
    }

    String text() {
        json.beginObject();
        json.put("scene", report.scene());
        json.put("command", report.command());
        json.put("complete", report.isComplete());
        json.put("points", report.points());
        json.put("pointsPlanned", report.pointsPlanned());
        json.put("seed", report.seed());
        json.put("threads", report.threads());
        json.put("gatherRadius", report.gatherRadius() > 0 ? report.gatherRadius() : Double.NaN);
        machine(report.machine());
        reference(report.reference());
        json.name("techniques").beginArray();
        report.studies().forEach(this::technique);
        json.end();
        json.name("shading").beginArray();
        report.shading().forEach(this::shading);
        json.end();
        report.cold().ifPresent(this::cold);
        return json.end().toString();
    }

    private void machine(Machine machine) {
        json.name("machine").beginObject();
        json.put("system", machine.system());
        json.put("processor", machine.processor());
        json.put("cores", machine.cores());
        json.put("java", machine.java());
        json.put("program", machine.program());
        json.end();
    }

    private void reference(Reference reference) {
        json.name("reference").beginObject();
        json.put("file", StudyFolder.REFERENCE);
        json.put("origin", reference.origin().name().toLowerCase(Locale.ROOT).replace('_', '-'));
        json.put("width", reference.picture().width());
        json.put("height", reference.picture().height());
        json.put("rays", reference.rays());
        json.put("batches", reference.batches());
        json.put("seconds", reference.seconds());
        json.put("error", reference.standardError().map(report::rootMeanSquare).orElse(Double.NaN));
        json.put("halvesDiffer", reference.halves().map(report::rootMeanSquare).orElse(Double.NaN));
        json.end();
    }

    private void technique(TechniqueStudy study) {
        Technique technique = study.technique();
        json.beginObject();
        json.put("name", technique.name());
        json.put("family", technique.family());
        json.put("preprocessor", technique.preProcessor());
        json.name("settings").beginObject();
        technique.overrides().forEach(json::put);
        json.end();
        json.put("raysAPass", technique.raysAPass());
        json.put("refusal", study.refusal().isEmpty() ? null : study.refusal());
        json.name("points").beginArray();
        study.points().forEach(this::point);
        json.end().end();
    }

    private void point(StudyPoint point) {
        json.beginObject();
        KeptJson.write(point, json);
        json.put("resolved", point.isResolved());
        json.name("means").beginObject();
        for (Measure measure : Measure.values()) {
            Distribution distribution = point.distribution(measure);
            json.name(measure.key()).beginObject();
            json.put("mean", distribution.mean());
            interval("band", distribution.band());
            interval("interval", distribution.meanInterval());
            json.end();
        }
        json.end().end();
    }

    private void interval(String name, Interval interval) {
        json.name(name).beginArray();
        json.value(interval.low()).value(interval.high());
        json.end();
    }

    private void shading(ShadingStudy study) {
        json.beginObject();
        json.put("shader", study.shader());
        study.run().values().forEach((measure, value) -> json.put(measure.key(), value));
        json.end();
    }

    private void cold(ColdTimes cold) {
        json.name("cold").beginObject();
        json.put("start", cold.start());
        json.put("budget", cold.budget().label());
        json.name("seconds").beginObject();
        cold.renders().forEach(json::put);
        json.end().end();
    }
}
