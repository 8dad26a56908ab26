package org.diacaustic.page;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.diacaustic.study.ColdTimes;
import org.diacaustic.study.StudyFolder;
import org.diacaustic.study.StudyPictures;
import org.diacaustic.study.StudyReport;
import org.diacaustic.study.TechniqueStudy;

/** A report as one HTML page that needs nothing else: for projectors, wide screens and telephones, light and dark. */
public final class StudyPage {
    private static final String[][] PARTS = {
        {"error", "Error"},
        {"axes", "Other costs"},
        {"reach", "Time to an error"},
        {"chance", "Bias and chance"},
        {"brightness", "Brightness"},
        {"pictures", "Pictures"},
        {"reference", "Reference"},
        {"time", "Where time goes"},
        {"numbers", "Numbers"},
        {"run", "How it was run"}
    };

    /** Parts that are there before anything was measured. */
    private static final Set<String> WITHOUT_POINTS = Set.of("reference", "run");

    private final StudyReport report;
    private final StudyPictures pictures;
    private final StudyNumbers numbers;
    private final List<Finding> findings;
    private final PageImages images = new PageImages();
    private final PageWriter page = new PageWriter();

    StudyPage(StudyReport report, StudyPictures pictures) {
        this.report = report;
        this.pictures = pictures;
        numbers = new StudyNumbers(report);
        findings = Findings.of(report);
    }

    /**
     * Writes the page, and its charts as files of their own.
     *
     * @return the page
     * @throws IOException if that fails
     */
    public static Path write(StudyReport report, StudyFolder folder) throws IOException {
        for (Map.Entry<String, String> chart : StudyCharts.files(report).entrySet()) {
            folder.write(StudyFolder.CHARTS + chart.getKey(), chart.getValue());
        }
        return folder.write("study.html", new StudyPage(report, folder).text());
    }

    String text() {
        page.add("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">");
        page.add("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">");
        page.format("<title>Error against run time: %s</title>", report.scene());
        page.add("<style>\n" + resource("study.css") + "</style>\n</head>\n<body>");
        head();
        if (!numbers.started().isEmpty()) {
            sections();
        }
        new ReferenceSection(report, images).write(page);
        if (!numbers.started().isEmpty()) {
            time();
            new NumbersSection(numbers).write(page);
        }
        new RunSection(report).write(page);
        page.add("<style>\n" + images.styles() + "</style>");
        page.add("<script>\n" + resource("study.js") + "</script>\n</body>\n</html>");
        return page.toString();
    }

    private static String resource(String name) {
        try (InputStream in = StudyPage.class.getResourceAsStream(name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new IllegalStateException(name + " cannot be read from the program's own files", e);
        }
    }

    private void head() {
        page.format("<header><p class=\"kicker\">Error against run time</p><h1>%s</h1>", report.scene());
        page.paragraph(compared());
        if (!report.isComplete()) {
            page.format(
                    "<p class=\"banner\"><b>partial: %d of %d points.</b> The study was stopped, or is still running; what is"
                            + " here may change when it goes on.</p>",
                    report.points(), report.pointsPlanned());
        }
        list(found(Finding.Kind.WINNER, Finding.Kind.FASTER, Finding.Kind.WRONG));
        List<Finding> others = found(Finding.Kind.STUCK, Finding.Kind.SHADING, Finding.Kind.REFUSED, Finding.Kind.NOTE);
        if (!others.isEmpty()) {
            page.format("<details><summary>What else it shows (%d)</summary>", others.size());
            list(others);
            page.add("</details>");
        }
        page.add("<nav>");
        Stream.of(PARTS)
                .filter(part -> !numbers.started().isEmpty() || WITHOUT_POINTS.contains(part[0]))
                .forEach(part -> page.format("<a href=\"#%s\">%s</a>", part[0], part[1]));
        page.add("</nav></header>");
    }

    /** The findings of some kinds, kind by kind. */
    private List<Finding> found(Finding.Kind... kinds) {
        return Stream.of(kinds)
                .flatMap(kind -> findings.stream().filter(finding -> finding.kind() == kind))
                .toList();
    }

    private void list(List<Finding> some) {
        page.add("<ul class=\"findings\">");
        some.forEach(finding -> page.format(
                "<li class=\"%s\">%s</li>", finding.kind().name().toLowerCase(Locale.ROOT), finding.text()));
        page.add("</ul>");
    }

    private String compared() {
        List<TechniqueStudy> started = numbers.started();
        List<String> budgets = started.stream()
                .flatMap(study -> study.points().stream())
                .map(point -> Numbers.budget(point.budget()))
                .distinct()
                .toList();
        int runs = started.stream()
                .flatMap(study -> study.points().stream())
                .mapToInt(point -> point.runs().size())
                .max()
                .orElse(0);
        int count = started.size();
        return count + (count == 1 ? " technique" : " techniques") + ", budgets of "
                + budgets.stream().collect(Collectors.joining(", ")) + ", up to " + runs
                + (runs == 1 ? " seed" : " seeds") + " each, all held against the same reference.";
    }

    private void sections() {
        ShownTechniques techniques = new ShownTechniques(numbers);
        StudyCharts charts = new StudyCharts(numbers, techniques);
        new ErrorSection(numbers, techniques, charts).write(page);
        new ChanceSection(numbers, techniques, charts).write(page);
        brightness(charts);
        new PictureSection(report, techniques, pictures, images).write(page);
    }

    private void brightness(StudyCharts charts) {
        page.section("brightness", "Brightness");
        list(found(Finding.Kind.WRONG));
        page.paragraph(
                "Mean difference to the reference over all pixels that count, as a part of the light that comes over specular"
                        + " surfaces, with the largest budget, and what holds the true one with a chance of 95 %. Coloured:"
                        + " certainly off by more than 1 %.");
        page.chart(charts.brightness());
        page.endSection();
    }

    private void time() {
        page.section("time", "Where time goes");
        page.chart(TimeBars.chart(numbers));
        page.remark("Shares of the time by the clock, which is written beside, with the largest budget of each"
                + " technique, in a process that is warm. Grey: planning, and what is not told apart.");
        Optional<ColdTimes> cold = report.cold();
        if (cold.isPresent()) {
            page.format(
                    "<h3>Cold: whole processes, budget of %s</h3>",
                    Numbers.budget(cold.get().budget()));
            page.table("numbers", List.of("", "start of Java", "the rest", "together"));
            double start = cold.get().start();
            numbers.started().stream()
                    .map(study -> study.technique().name())
                    .filter(cold.get().renders()::containsKey)
                    .forEach(name -> {
                        double all = cold.get().renders().get(name);
                        page.row(List.of(
                                name, Numbers.seconds(start), Numbers.seconds(all - start), Numbers.seconds(all)));
                    });
            page.endTable();
        }
        page.endSection();
    }
}
