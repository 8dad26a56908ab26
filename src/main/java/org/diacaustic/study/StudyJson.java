package org.diacaustic.study;

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
        json.put("threads", report.threads());
        json.put("counted", StudyFiles.COUNTED);
        reference(report.reference());
        json.name("techniques").beginArray();
        report.studies().forEach(this::technique);
        json.end();
        json.end();
        return json.toString();
    }

    private void reference(Reference reference) {
        json.name("reference").beginObject();
        json.put("file", StudyFiles.REFERENCE);
        json.put("width", reference.picture().width());
        json.put("height", reference.picture().height());
        json.put("lightRays", reference.lightRays());
        json.put("batches", reference.batches());
        json.put("seconds", reference.seconds());
        json.put("hasStandardError", reference.standardError().isPresent());
        json.end();
    }

    private void technique(TechniqueStudy study) {
        json.beginObject();
        json.put("name", study.technique().name());
        json.put(
                "way",
                switch (study.technique().way()) {
                    case OVER_A_MAP -> "over-a-map";
                    case INTO_PIXELS -> "into-pixels";
                });
        json.name("settings").beginObject();
        study.technique().overrides().forEach(json::put);
        json.end();
        json.put("refusal", study.refusal().isEmpty() ? null : study.refusal());
        json.name("slope").beginObject();
        json.put("value", study.slope().value());
        json.put("standardError", study.slope().standardError());
        json.put("points", study.slope().points());
        json.end();
        json.name("runs").beginArray();
        study.runs().forEach(run -> run(study.technique(), run));
        json.end().end();
    }

    private void run(Technique technique, StudyRun run) {
        PictureError error = run.error();
        json.beginObject();
        json.put("rays", run.rays());
        json.put("lightRays", run.lightRays());
        json.put("seconds", run.seconds());
        json.put("processorSeconds", run.processorSeconds());
        json.put("rRMSE", error.rms());
        json.put("relMAE", error.absolute());
        json.put("bias", error.bias());
        json.put("measuredRRMSE", error.measuredRms());
        json.put("measuredRelMAE", error.measuredAbsolute());
        json.put("referenceNoise", error.noiseRms());
        json.put("leastRRMSE", error.leastRms());
        json.put("resolved", error.isResolved());
        json.put("pixels", error.pixels());
        json.put("file", StudyFiles.picture(technique, run) + ".pfm");
        json.end();
    }
}
