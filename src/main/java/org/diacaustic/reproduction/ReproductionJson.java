package org.diacaustic.reproduction;

import org.diacaustic.json.JsonWriter;

/** A report as JSON. */
final class ReproductionJson {
    private final ReproductionReport report;
    private final JsonWriter json = new JsonWriter();

    ReproductionJson(ReproductionReport report) {
        this.report = report;
    }

    String text() {
        json.beginObject();
        json.put("firstSeed", report.firstSeed());
        json.put("seeds", report.seeds());
        json.put("threads", report.threads());
        json.put("seconds", report.seconds());
        json.name("tables").beginArray();
        report.comparisons().forEach(this::table);
        json.end();
        json.name("experiments").beginArray();
        report.results().all().forEach(this::experiment);
        json.end();
        json.name("identities").beginArray();
        report.identities().forEach(this::identity);
        json.end();
        json.name("statements").beginArray();
        report.verdicts().forEach(this::verdict);
        json.end();
        json.name("figures").beginArray();
        report.figures().forEach(this::figure);
        json.end();
        json.end();
        return json.toString();
    }

    private void table(Comparison comparison) {
        PublishedTable table = comparison.table();
        json.beginObject();
        json.put("number", table.number());
        json.put("scene", table.scene().key());
        json.put("title", table.title());
        json.name("rows").beginArray();
        for (Comparison.Row row : comparison.rows()) {
            json.beginObject();
            json.put("method", row.published().method().key());
            json.put("map", row.published().map().key());
            json.name("values").beginObject();
            row.cells().forEach(this::cell);
            json.end().end();
        }
        json.end().end();
    }

    private void cell(Cell cell) {
        json.name(cell.quantity().key()).beginObject();
        json.put("published", cell.published().orElse(Double.NaN));
        json.put("mean", cell.ours().mean());
        json.put("standardDeviation", cell.ours().deviation());
        json.put("difference", cell.difference().orElse(Double.NaN));
        cell.remark().ifPresent(remark -> json.put("remark", remark.reason()));
        json.name("values").beginArray();
        cell.ours().values().forEach(value -> json.value((double) value));
        json.end().end();
    }

    /** Everything that was counted, whether or not the thesis has it. */
    private void experiment(Outcome outcome) {
        json.beginObject();
        json.put("scene", outcome.experiment().scene().key());
        json.put("method", outcome.experiment().method().key());
        json.put("map", outcome.experiment().map().key());
        json.name("counts").beginObject();
        outcome.counts().forEach((quantity, statistic) -> {
            json.name(quantity.key()).beginObject();
            json.put("mean", statistic.mean());
            json.put("standardDeviation", statistic.deviation());
            json.end();
        });
        json.end().end();
    }

    private void identity(Identity identity) {
        json.beginObject();
        json.put("claim", identity.claim());
        json.put("expected", identity.expected());
        json.put("found", identity.found());
        json.put("holds", identity.holds());
        json.end();
    }

    private void verdict(Verdict verdict) {
        json.beginObject();
        json.put("number", verdict.statement().number());
        json.put("claim", verdict.statement().claim());
        json.put("section", verdict.statement().section());
        json.put("finding", verdict.finding().title());
        json.put("evidence", verdict.evidence());
        json.end();
    }

    private void figure(Figure figure) {
        json.beginObject();
        json.put("number", figure.number());
        json.put("scene", figure.scene().key());
        json.put("caption", figure.caption());
        json.put("file", "figures/" + figure.fileName() + ".png");
        json.end();
    }
}
