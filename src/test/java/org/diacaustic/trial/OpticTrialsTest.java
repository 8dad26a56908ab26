package org.diacaustic.trial;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.diacaustic.parallel.Workers;
import org.diacaustic.stability.CaseFile;
import org.diacaustic.stability.CaseResult;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;
import org.diacaustic.stability.StabilityRun;
import org.diacaustic.stability.Values;
import org.diacaustic.stability.Verdict;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Trials of maps, bumps, absorption, cameras, pictures, nesting, combinations and lights pass, and could have failed. */
class OpticTrialsTest {
    /** What these cases expect is words, or for the most part. */
    private static final Set<String> WORDS =
            Set.of("beer_edge", "camera_degenerate", "light_on_surface", "light_at_camera", "bump_refract");

    /** What this case asks takes a second. */
    private static final String LONG = "beer_segments";

    private static final Operations OPERATIONS = operations();

    private static Operations operations() {
        Operations operations = new Operations();
        MappingTrials.addTo(operations);
        AmbientMapTrials.addTo(operations);
        BumpTrials.addTo(operations);
        AbsorptionTrials.addTo(operations);
        CameraTrials.addTo(operations);
        PictureTrials.addTo(operations);
        NestingTrials.addTo(operations);
        CombinationTrials.addTo(operations);
        LightTrials.addTo(operations);
        LampTrials.addTo(operations);
        return operations;
    }

    static Stream<NumericCase> cases() {
        return CaseFile.bundled().stream()
                .filter(one -> OPERATIONS.find(one.operation()).isPresent())
                .filter(one -> !one.operation().equals(LONG));
    }

    static Stream<NumericCase> casesOfNumbers() {
        return cases().filter(one -> !WORDS.contains(one.operation()));
    }

    @ParameterizedTest
    @MethodSource("cases")
    void trial_givenBundledCase_passes(NumericCase asked) {
        CaseResult result = run(asked);
        assertThat(result.verdict())
                .as("%s: %s", asked.id(), result.checks().isEmpty() ? result.reason() : result.worst())
                .isIn(Verdict.STRETCH, Verdict.PASS);
    }

    @ParameterizedTest
    @MethodSource("casesOfNumbers")
    void trial_givenOtherAnswers_fails(NumericCase asked) {
        Map<String, Object> wrong = new LinkedHashMap<>();
        for (String key : asked.expected().keys()) {
            wrong.put(key, changed(value(asked.expected(), key)));
        }
        assertThat(run(with(asked, asked.inputs(), Values.of("expected", wrong)))
                        .verdict())
                .as(asked.id() + " with " + wrong)
                .isEqualTo(Verdict.FAIL);
    }

    private static Object value(Values values, String key) {
        String text = values.text(key);
        return text.startsWith("[") ? values.list(key) : text;
    }

    /** Numbers are made others, and lists one longer if they hold none. */
    private static Object changed(Object value) {
        if (value instanceof List<?> list) {
            return list.isEmpty()
                    ? List.of(List.of(5, 6))
                    : list.stream().map(OpticTrialsTest::changed).toList();
        }
        try {
            return new BigDecimal(value.toString())
                    .multiply(BigDecimal.valueOf(2))
                    .add(new BigDecimal(3))
                    .toString();
        } catch (NumberFormatException word) {
            return value;
        }
    }

    @Test
    void bumpRefract_givenAnotherDirection_fails() {
        NumericCase flat =
                cases().filter(one -> one.id().equals("P-BUMP-04")).findFirst().orElseThrow();
        Values wrong = Values.of(
                "expected", Map.of("naive_refraction", List.of(0.48, -0.87, 0), "naive_refraction_dot_Ng", "-0.87"));
        assertThat(run(with(flat, flat.inputs(), wrong)).verdict()).isEqualTo(Verdict.FAIL);
    }

    @Test
    void beerSegments_givenAThousand_isTheirProductAndNothingElse() {
        NumericCase asked = CaseFile.bundled().stream()
                .filter(one -> one.operation().equals(LONG))
                .findFirst()
                .orElseThrow();
        Values inputs = Values.of("inputs", Map.of("sigma", 0.5, "distance", 2.0, "segments", 1000));
        assertThat(run(with(asked, inputs, asked.expected())).verdict()).isEqualTo(Verdict.PASS);
        Values wrong = Values.of("expected", Map.of("T", "0.3678795"));
        assertThat(run(with(asked, inputs, wrong)).verdict()).isEqualTo(Verdict.FAIL);
    }

    @Test
    void trials_givenWordsThatNobodyKnows_sayWhyTheyDoNotApply() {
        for (NumericCase asked : cases().toList()) {
            NumericCase empty = with(asked, Values.of("inputs", Map.of()), asked.expected());
            if (!asked.inputs().keys().equals(Set.of("n"))) {
                assertThat(run(empty).reason()).as(asked.id()).startsWith("the case does not give");
            }
        }
    }

    private static NumericCase with(NumericCase asked, Values inputs, Values expected) {
        return new NumericCase(
                asked.id(),
                asked.category(),
                asked.title(),
                asked.operation(),
                inputs,
                expected,
                asked.tolerance(),
                asked.acceptable(),
                asked.typicalFailure());
    }

    private static CaseResult run(NumericCase asked) {
        return new StabilityRun(OPERATIONS, Set.of())
                .run(List.of(asked), new Workers(1), result -> {})
                .results()
                .get(0);
    }
}
