package org.diacaustic.reproduction;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.diacaustic.chart.Html;

/** A report as one HTML page that needs nothing else: for wide screens and for phones, light and dark. */
final class ReproductionPage {
    /** Differences up to here are called close. */
    private static final double CLOSE = 0.05;

    private final ReproductionReport report;
    private final Map<Figure, String> images;
    private final StringBuilder out = new StringBuilder();

    /** @param images the figures as addresses that hold the picture itself */
    ReproductionPage(ReproductionReport report, Map<Figure, String> images) {
        this.report = report;
        this.images = images;
    }

    String text() {
        add("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">");
        add("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">");
        add("<title>The thesis, rendered again</title>\n<style>\n" + style() + "</style>\n</head>\n<body>");
        introduction();
        statements();
        identities();
        report.scenes().forEach(this::scene);
        add("</body>\n</html>");
        return out.toString();
    }

    private static String style() {
        try (InputStream in = ReproductionPage.class.getResourceAsStream("reproduction.css")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new IllegalStateException("reproduction.css cannot be read from the program's own files", e);
        }
    }

    private void introduction() {
        add("<h1>The thesis, rendered again</h1>");
        add(
                "<p>H. A. Bailey, <cite>Ray Tracing Techniques for Indirect Refracted Illumination</cite> (Acadia University,"
                        + " 1999), has three scenes, seven techniques, tables of what they cost and the pictures they make. All of it"
                        + " was rendered again here; every number called ours, and every verdict, comes from this run.</p>");
        add(text(
                "<p>Random techniques ran with %d %s from %d on and are given as mean ± standard deviation of one run; their"
                        + " pictures are of the first. The thesis shows one draw of each. %.0f seconds on %d %s.</p>",
                report.seeds(),
                report.seeds() == 1 ? "seed" : "seeds",
                report.firstSeed(),
                report.seconds(),
                report.threads(),
                report.threads() == 1 ? "thread" : "threads"));
        add(
                "<p>The thesis gives neither cameras nor sizes. They were found so that its counts come out, which leaves some"
                        + " numbers out of reach and makes a few come out by themselves; both are marked †, with the reason.</p>");
        agreement();
        add("<nav><a href=\"#statements\">Statements</a><a href=\"#identities\">Exact numbers</a>"
                + report.scenes().stream()
                        .map(scene -> "<a href=\"#" + scene.key() + "\">" + title(scene) + "</a>")
                        .collect(Collectors.joining())
                + "</nav>");
    }

    private void agreement() {
        List<Double> differences = report.comparisons().stream()
                .flatMap(comparison -> comparison.rows().stream())
                .flatMap(row -> row.cells().stream())
                .flatMap(cell -> cell.difference().stream())
                .toList();
        add(text(
                "<p>Of %d published numbers %d came out the same as printed, and %d within %.0f %%.</p>",
                differences.size(),
                differences.stream().filter(difference -> difference == 0).count(),
                differences.stream()
                        .filter(difference -> Math.abs(difference) <= CLOSE)
                        .count(),
                100 * CLOSE));
    }

    private void statements() {
        add(
                "<h2 id=\"statements\">What the thesis concludes</h2>\n<div class=\"scroll\"><table><thead><tr><th>Statement</th>"
                        + "<th>Section</th><th>Finding</th></tr></thead><tbody>");
        for (Verdict verdict : report.verdicts()) {
            String style = switch (verdict.finding()) {
                case CONFIRMED -> "good";
                case CONTRADICTED -> "bad";
                case NOT_TESTED -> "far";
            };
            add(text(
                    "<tr><td>%d. %s<span class=\"evidence\">%s</span></td><td>%s</td><td class=\"finding %s\">%s</td></tr>",
                    verdict.statement().number(),
                    Html.escape(verdict.statement().claim()),
                    Html.escape(verdict.evidence()),
                    Html.escape(verdict.statement().section()),
                    style,
                    verdict.finding().title()));
        }
        add("</tbody></table></div>");
    }

    private void identities() {
        add("<h2 id=\"identities\">What must come out exactly</h2>");
        add(
                "<p>Some numbers leave no room for chance: points of a lattice within a square, and sums that every row of the"
                        + " thesis obeys.</p>");
        add("<div class=\"scroll\"><table><thead><tr><th>Identity</th><th>Must be</th><th>Is</th></tr></thead><tbody>");
        for (Identity identity : report.identities()) {
            add(text(
                    "<tr><td>%s</td><td>%s</td><td class=\"%s\">%s %s</td></tr>",
                    Html.escape(identity.claim()),
                    Html.escape(identity.expected()),
                    identity.holds() ? "good" : "bad",
                    identity.holds() ? "✓" : "✗",
                    Html.escape(identity.found())));
        }
        add("</tbody></table></div>");
    }

    private void scene(ThesisScene scene) {
        add(text("<h2 id=\"%s\">%s scene</h2>", scene.key(), title(scene)));
        report.comparisons().stream()
                .filter(comparison -> comparison.table().scene() == scene)
                .forEach(this::comparison);
        List<Figure> figures = report.figures().stream()
                .filter(figure -> figure.scene() == scene)
                .toList();
        figures.stream().filter(figure -> figure.svg().isPresent()).forEach(this::chart);
        add("<h3>Pictures</h3>\n<div class=\"figures\">");
        figures.stream().filter(figure -> figure.svg().isEmpty()).forEach(this::picture);
        add("</div>");
    }

    private static String title(ThesisScene scene) {
        return scene.name().charAt(0) + scene.key().substring(1);
    }

    private void chart(Figure figure) {
        add("<h3>" + Html.escape(figure.caption()) + "</h3>");
        add("<div class=\"chart\">" + figure.svg().orElseThrow() + "</div>");
        add(
                "<p class=\"remarks\">Bars begin at 100,000 tests; on a logarithmic axis their lengths are no proportions. Outlines"
                        + " are the thesis' numbers, full bars ours.</p>");
    }

    private void picture(Figure figure) {
        add(text(
                "<figure><img src=\"%s\" width=\"%d\" height=\"%d\" alt=\"%s\"><figcaption>%s</figcaption></figure>",
                images.get(figure),
                figure.picture().width(),
                figure.picture().height(),
                Html.escape(figure.caption()),
                Html.escape(figure.caption())));
    }

    private void comparison(Comparison comparison) {
        PublishedTable table = comparison.table();
        add(text("<h3>Table %d. %s</h3>", table.number(), Html.escape(table.title())));
        add("<div class=\"scroll\"><table class=\"numbers\"><thead><tr><th>Technique</th>"
                + comparison.columns().stream()
                        .map(column -> "<th>" + Html.escape(column.title()) + "</th>")
                        .collect(Collectors.joining())
                + "</tr></thead><tbody>");
        List<PublishedTable.Remark> remarks = new ArrayList<>();
        for (Comparison.Row row : comparison.rows()) {
            add("<tr><th>" + Html.escape(row.published().method().title()) + "</th>"
                    + row.cells().stream().map(this::cell).collect(Collectors.joining())
                    + "</tr>");
            row.cells().stream()
                    .flatMap(cell -> cell.remark().stream())
                    .filter(remark -> !remarks.contains(remark))
                    .forEach(remarks::add);
        }
        add("</tbody></table></div>");
        if (!remarks.isEmpty()) {
            add("<ul class=\"remarks\">"
                    + remarks.stream()
                            .map(remark -> "<li>† " + Html.escape(remark.reason()) + "</li>")
                            .collect(Collectors.joining())
                    + "</ul>");
        }
    }

    private String cell(Cell cell) {
        StringBuilder html = new StringBuilder("<td><span class=\"ours\">");
        html.append(number(cell.ours().mean(), cell.quantity()));
        if (cell.ours().count() > 1) {
            html.append(" <span class=\"spread\">± ")
                    .append(number(cell.ours().deviation(), cell.quantity()))
                    .append("</span>");
        }
        html.append("</span>");
        if (cell.published().isPresent()) {
            html.append("<span class=\"thesis\">thesis ")
                    .append(number(cell.published().get(), cell.quantity()))
                    .append("</span>")
                    .append(difference(cell));
        }
        return html.append("</td>").toString();
    }

    private static String difference(Cell cell) {
        double difference = cell.difference().orElseThrow();
        boolean isWithinSpread =
                Math.abs(cell.published().orElseThrow() - cell.ours().mean())
                        <= 2 * cell.ours().deviation();
        String style = Math.abs(difference) <= CLOSE || isWithinSpread
                ? "good"
                : cell.remark().isPresent() ? "far" : "bad";
        String distance = cell.deviations()
                .map(deviations -> text(", %.1f sd", deviations))
                .orElse("");
        String shown = difference == 0 ? "same" : text("%+.1f %%", 100 * difference);
        return text(
                "<span class=\"difference %s\">%s%s%s</span>",
                style, shown, distance, cell.remark().isPresent() ? " †" : "");
    }

    private static String number(double value, Quantity quantity) {
        return text("%,." + quantity.decimals() + "f", value);
    }

    private static String text(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }

    private void add(String html) {
        out.append(html).append('\n');
    }
}
