package org.diacaustic.trial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.diacaustic.parallel.Workers;
import org.diacaustic.stability.CaseFile;
import org.diacaustic.stability.CaseResult;
import org.diacaustic.stability.Launcher;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.StabilityRun;
import org.diacaustic.stability.Values;
import org.diacaustic.stability.Verdict;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Trials of light: right answers pass, and each wrong one fails. */
class LightTrialsTest {
    private static CaseResult run(NumericCase asked) {
        Launcher none = new Launcher(Path.of("java"), List.of(), Optional.empty());
        return new StabilityRun(Trials.all(none), Set.of())
                .run(List.of(asked), new Workers(1), result -> {})
                .results()
                .get(0);
    }

    private static NumericCase bundled(String operation) {
        return CaseFile.bundled().stream()
                .filter(each -> each.operation().equals(operation))
                .findFirst()
                .orElseThrow();
    }

    private static NumericCase with(NumericCase asked, Map<String, Object> inputs, Map<String, Object> expected) {
        return new NumericCase(
                asked.id(),
                asked.category(),
                asked.title(),
                asked.operation(),
                Values.of("inputs", inputs),
                Values.of("expected", expected),
                asked.tolerance(),
                asked.acceptable(),
                asked.typicalFailure());
    }

    private static Map<String, Object> copy(Values values) {
        Map<String, Object> copy = new HashMap<>();
        for (String key : values.keys()) {
            boolean isList = values.text(key).startsWith("[");
            copy.put(key, isList ? values.list(key) : values.isDecimal(key) ? values.decimal(key) : values.text(key));
        }
        return copy;
    }

    /** The case once for each number of its answer, which is half too large; of a list the first. */
    private static List<NumericCase> wrong(NumericCase asked) {
        List<NumericCase> wrong = new ArrayList<>();
        for (Map.Entry<String, Object> answer : copy(asked.expected()).entrySet()) {
            Object value = answer.getValue();
            Map<String, Object> changed = copy(asked.expected());
            if (value instanceof BigDecimal number) {
                changed.put(
                        answer.getKey(), number.multiply(new BigDecimal("1.5")).add(new BigDecimal("1e-3")));
            } else if (value instanceof List<?> list) {
                List<Object> numbers = new ArrayList<>(list);
                numbers.set(0, new BigDecimal(numbers.get(0).toString()).multiply(new BigDecimal("1.5")));
                changed.put(answer.getKey(), numbers);
            } else {
                continue;
            }
            wrong.add(with(asked, copy(asked.inputs()), changed));
        }
        return wrong;
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "snell_window",
                "sphere_focus",
                "mirror_caustic",
                "light_in_sphere",
                "sphere_flux_split",
                "glass_furnace"
            })
    void run_givenAWrongAnswer_fails(String operation) {
        NumericCase right = bundled(operation);
        assertThat(run(right).verdict()).isIn(Verdict.STRETCH, Verdict.PASS);
        assertThat(wrong(right))
                .isNotEmpty()
                .allSatisfy(each -> assertThat(run(each).verdict())
                        .as(each.expected().toString())
                        .isEqualTo(Verdict.FAIL));
    }

    @Test
    void run_givenLightBetweenMattSurfaces_doesNotApply() {
        assertThat(run(bundled("furnace")).reason()).contains("diffuse bounce");
    }

    @Test
    void run_givenNextToNoAbsorption_booksAllDigitsOfIt() {
        // T = 0.96, R = 0.04, e = exp(−1e-9): 1 − T·e ÷ (1 − R·e²), by 50 digits.
        NumericCase asked = with(
                bundled("light_in_sphere"),
                Map.of("n", 1.5, "sigma", 1e-9, "R", 1.0),
                Map.of(
                        "first_pass_escaped_fraction", "0.9599999990400000004799999",
                        "all_passes_escaped_fraction", "0.9999999989166666673402777",
                        "absorbed_fraction", "1.083333332659722290062580e-9"));
        assertThat(run(asked).verdict()).isEqualTo(Verdict.PASS);
    }

    @Test
    void score_givenRuns_isInStandardErrors() {
        // The mean is 2, the variance of the runs 1, that of their mean 1/4.
        double half = Math.sqrt(0.75);
        Estimate estimate = Estimate.of(2 - half, 2 - half, 2 + half, 2 + half);
        assertThat(estimate.score(1)).isCloseTo(2, within(1e-12));
    }
}
