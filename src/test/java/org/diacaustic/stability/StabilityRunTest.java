package org.diacaustic.stability;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import org.diacaustic.parallel.Workers;
import org.junit.jupiter.api.Test;

class StabilityRunTest {
    private static final Operations OPERATIONS = new Operations()
            .add("right", "is right", (asked, checks) -> checks.number("x", 2))
            .add("wrong", "is wrong", (asked, checks) -> checks.number("x", 3))
            .add("breaks", "breaks off", (asked, checks) -> {
                throw new IllegalStateException("broken");
            })
            .add("refuses", "refuses", (asked, checks) -> {
                throw new IllegalArgumentException("a radius must be positive");
            })
            .add("asksLate", "is wrong, and asks for more", (asked, checks) -> {
                checks.number("x", 3);
                asked.inputs().number("y");
            })
            .add("asks", "asks for more", (asked, checks) -> asked.inputs().number("y"))
            .add(new Operation(
                    "faults", "starts processes", Operation.Need.FAULTS, (asked, checks) -> checks.holds("ran", true)));

    private static NumericCase asked(String operation) {
        return TestCases.of(operation, Map.of("x", "2"), Map.of("x_abs", 0.5));
    }

    private static List<CaseResult> run(Set<Operation.Need> allowed, String... operations) {
        List<CaseResult> heard = new ArrayList<>();
        List<NumericCase> cases =
                List.of(operations).stream().map(StabilityRunTest::asked).toList();
        new StabilityRun(OPERATIONS, allowed).run(cases, new Workers(3), heard::add);
        return heard;
    }

    @Test
    void run_givenCases_saysWhatBecameOfEach() {
        List<CaseResult> results = run(Set.of(), "right", "wrong", "breaks", "asks", "unknown", "faults");
        assertThat(results)
                .extracting(CaseResult::verdict)
                .containsExactly(
                        Verdict.PASS,
                        Verdict.FAIL,
                        Verdict.FAIL,
                        Verdict.NOT_APPLICABLE,
                        Verdict.NOT_APPLICABLE,
                        Verdict.NOT_APPLICABLE);
        assertThat(results.get(2).worst().got()).contains("broken");
        assertThat(results.get(3).reason()).isEqualTo("the case does not give inputs.y");
        assertThat(results.get(4).reason()).isEqualTo("there is no operation unknown");
        assertThat(results.get(5).reason()).contains("--faults");
        assertThat(run(Set.of(Operation.Need.FAULTS), "faults").get(0).verdict())
                .isEqualTo(Verdict.PASS);
    }

    /** What has failed stays so, whatever cannot be read after it. */
    @Test
    void run_givenAFailureBeforeAFault_fails() {
        assertThat(run(Set.of(), "asksLate").get(0).verdict()).isEqualTo(Verdict.FAIL);
    }

    @Test
    void run_givenARefusal_passesOnlyIfThatIsTheAnswer() {
        assertThat(run(Set.of(), "refuses").get(0).verdict()).isEqualTo(Verdict.FAIL);
        NumericCase rejected = TestCases.of("refuses", Map.of("result", "rejected with a message"), Map.of());
        CaseResult result = new StabilityRun(OPERATIONS, Set.of())
                .run(List.of(rejected), new Workers(1), each -> {})
                .results()
                .get(0);
        assertThat(result.verdict()).isEqualTo(Verdict.PASS);
        assertThat(result.worst().got()).isEqualTo("a radius must be positive");
    }

    @Test
    void run_givenManyCases_tellsThemInOrder() {
        List<NumericCase> cases = IntStream.range(0, 200)
                .mapToObj(i -> asked(i % 3 == 0 ? "right" : "wrong"))
                .toList();
        List<CaseResult> heard = new ArrayList<>();
        StabilityReport report = new StabilityRun(OPERATIONS, Set.of()).run(cases, new Workers(4), heard::add);
        assertThat(heard).extracting(CaseResult::asked).isEqualTo(cases);
        assertThat(report.count(Verdict.PASS)).isEqualTo(67);
        assertThat(report.count(Verdict.FAIL)).isEqualTo(133);
    }

    @Test
    void report_givenResults_isTheSameInLinesPageAndJson() {
        List<NumericCase> cases = List.of(asked("right"), asked("wrong"), asked("unknown"));
        StabilityReport report = new StabilityRun(OPERATIONS, Set.of()).run(cases, new Workers(1), result -> {});
        // |3 − 2| ÷ 0.5
        assertThat(StabilityText.line(report.results().get(1)))
                .isEqualTo("T-1  a case  x: expected 2, got 3.0  2.00  FAIL");
        CategorySummary summary = report.categories().get(0);
        assertThat(summary.medianRatio()).isEqualTo(1);
        assertThat(StabilityText.line(summary))
                .isEqualTo(
                        "TEST       3  1 pass  1 not applicable  1 FAIL  error/tolerance: median 1.00, worst 2.00 at T-1");
        assertThat(report.page())
                .contains("| TEST | 3 | 0 | 1 | 0 | 1 | 1 | 1.00 | 2.00 | T-1 |")
                .contains("there is no operation unknown")
                .contains("| `breaks` | breaks off |");
        assertThat(report.json()).contains("\"verdict\": \"FAIL\"").contains("\"errorOverTolerance\": 2");
    }
}
