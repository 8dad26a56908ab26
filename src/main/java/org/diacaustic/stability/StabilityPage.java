package org.diacaustic.stability;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Collectors;

/** A report as a page of Markdown: what was tried, what renderers do wrong there, what came, and how far off that is. */
final class StabilityPage {
    private final StringBuilder page = new StringBuilder(1 << 16);

    private final Operations operations;

    private StabilityPage(Operations operations) {
        this.operations = operations;
    }

    static String of(StabilityReport report) {
        return new StabilityPage(report.operations()).write(report);
    }

    private String write(StabilityReport report) {
        line("# Numerical stability");
        line("");
        line(
                "Made by `java -jar target/diacaustic.jar stability --faults -o docs`; do not edit. Each case is a question with an");
        line(
                "exact answer, put to the code that renders, or a fault that the program is put to. *Error ÷ tolerance* is at most 1");
        line(
                "where a case passes; 0 is exact to the last digit, or a rule that holds. What is random is seeded, so these numbers are");
        line("the same every time on every machine.");
        line("");
        line(
                "A case is at **stretch** if it is within the tolerance of careful arithmetic that it names, it **passes** within that of a");
        line(
                "backward-stable algorithm, and is **render-safe** within that + 1e-9 · max(|value|, size of the object). Cases that cannot apply say why.");
        line("");
        line("| category | cases | stretch | pass | render-safe | not applicable | FAIL | median | worst | of |");
        line("|---|---|---|---|---|---|---|---|---|---|");
        report.categories().forEach(this::row);
        line("");
        line(StabilityText.summary(report).replaceAll("; [0-9.]+ s$", "") + ".");
        for (CategorySummary category : report.categories()) {
            line("");
            line("## " + category.category());
            line("");
            line("| case | tried | what goes wrong elsewhere | expected | got | error ÷ tolerance | |");
            line("|---|---|---|---|---|---|---|");
            report.results().stream()
                    .filter(result -> result.asked().category().equals(category.category()))
                    .forEach(this::row);
        }
        describeOperations();
        return page.toString();
    }

    private void row(CategorySummary category) {
        Optional<CaseResult> worst = category.worst().filter(result -> !isFault(result.asked()));
        row(
                category.category(),
                Integer.toString(category.cases()),
                Integer.toString(category.count(Verdict.STRETCH)),
                Integer.toString(category.count(Verdict.PASS)),
                Integer.toString(category.count(Verdict.RENDER_SAFE)),
                Integer.toString(category.count(Verdict.NOT_APPLICABLE)),
                Integer.toString(category.count(Verdict.FAIL)),
                worst.map(result -> StabilityText.ratio(category.medianRatio())).orElse(""),
                worst.map(result -> StabilityText.ratio(result.ratio())).orElse(""),
                worst.map(result -> result.asked().id()).orElse(""));
    }

    private void row(CaseResult result) {
        NumericCase asked = result.asked();
        if (!result.reason().isEmpty()) {
            row(
                    asked.id(),
                    cell(asked.title()),
                    cell(asked.typicalFailure()),
                    "",
                    cell(result.reason()),
                    "",
                    "not applicable");
            return;
        }
        Check worst = result.worst();
        if (isFault(asked) && result.verdict() != Verdict.FAIL) {
            // Times, and what the program said, are others every time.
            String checks = result.checks().size() + " checks hold";
            row(
                    asked.id(),
                    cell(asked.title()),
                    cell(asked.typicalFailure()),
                    "",
                    checks,
                    "",
                    result.verdict().toString());
            return;
        }
        row(
                asked.id(),
                cell(asked.title()),
                cell(asked.typicalFailure()),
                cell(worst.what() + " = " + worst.expected()),
                cell(worst.got()),
                StabilityText.ratio(result.ratio()),
                result.verdict().toString());
    }

    private boolean isFault(NumericCase asked) {
        return operations
                .find(asked.operation())
                .filter(operation -> operation.need() == Operation.Need.FAULTS)
                .isPresent();
    }

    private void describeOperations() {
        line("");
        line("## What is run");
        line("");
        line(
                "Cases of one operation are put to the same code. Where a case gives a rule in words, this is how it is read.");
        line("");
        line("| operation | what is run |");
        line("|---|---|");
        for (Operation operation : operations.all()) {
            row("`" + operation.name() + "`", cell(operation.meaning()));
        }
    }

    private void row(String... cells) {
        line(Arrays.stream(cells).collect(Collectors.joining(" | ", "| ", " |")));
    }

    private static String cell(String text) {
        return StabilityText.oneLine(text)
                .replace("\\", "\\\\")
                .replace("|", "\\|")
                .replace("<", "&lt;")
                .replace("*", "\\*");
    }

    private void line(String text) {
        page.append(text).append('\n');
    }
}
