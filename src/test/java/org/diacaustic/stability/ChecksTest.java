package org.diacaustic.stability;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

class ChecksTest {
    private static CaseResult result(Map<String, ?> expected, Map<String, ?> tolerance, Consumer<Checks> compare) {
        Checks checks = new Checks(TestCases.of("op", expected, tolerance));
        compare.accept(checks);
        return checks.result(0);
    }

    private static Verdict verdict(Map<String, ?> tolerance, double got) {
        return result(Map.of("x", "2.0"), tolerance, checks -> checks.number("x", got))
                .verdict();
    }

    @Test
    void number_givenItsError_hasTheVerdictOfItsTier() {
        Map<String, Double> tolerance = Map.of("x_abs", 1e-12, "stretch_x_abs", 1e-14);
        assertThat(verdict(tolerance, 2 + 4e-15)).isEqualTo(Verdict.STRETCH);
        assertThat(verdict(tolerance, 2 - 5e-13)).isEqualTo(Verdict.PASS);
        // 1e-12 + 1e-9 · 2
        assertThat(verdict(tolerance, 2 + 1.9e-9)).isEqualTo(Verdict.RENDER_SAFE);
        assertThat(verdict(tolerance, 2 + 2.1e-9)).isEqualTo(Verdict.FAIL);
        assertThat(verdict(tolerance, Double.NaN)).isEqualTo(Verdict.FAIL);
        assertThat(verdict(tolerance, Double.POSITIVE_INFINITY)).isEqualTo(Verdict.FAIL);
    }

    @Test
    void number_givenTolerancesByName_takesItsOwnBeforeThoseOfAll() {
        assertThat(verdict(Map.of("x_rel", 1e-6, "rel", 1e-15), 2 + 1.9e-6)).isEqualTo(Verdict.PASS);
        assertThat(verdict(Map.of("x_rel", 1e-6, "x_abs", 1e-6), 2 + 2.9e-6)).isEqualTo(Verdict.PASS);
        assertThat(verdict(Map.of("x_rel", 1e-6), 2 + 2.9e-6)).isEqualTo(Verdict.FAIL);
        assertThat(verdict(Map.of("rel", 1e-6), 2 + 1.9e-6)).isEqualTo(Verdict.PASS);
        assertThat(verdict(Map.of("y_abs", 1.0), 2 + 1e-6)).isEqualTo(Verdict.FAIL);
        assertThat(verdict(Map.of("exact", true), 2)).isEqualTo(Verdict.PASS);
        assertThat(verdict(Map.of("exact", true), Math.nextUp(2.0))).isEqualTo(Verdict.RENDER_SAFE);
    }

    /** 0.1 as it is written is not the double 0.1: the error is that of all digits. */
    @Test
    void number_givenMoreDigitsThanADoubleHas_measuresAgainstAllOfThem() {
        CaseResult result = result(Map.of("x", "0.1"), Map.of("x_abs", 1e-17), checks -> checks.number("x", 0.1));
        assertThat(result.worst().error()).isCloseTo(5.551115123125783e-18, within(1e-30));
        assertThat(result.ratio()).isCloseTo(0.5551115123125783, within(1e-12));
    }

    @Test
    void number_givenAnInfiniteAnswer_mustBeThat() {
        Map<String, String> expected = Map.of("x", "inf");
        assertThat(result(expected, Map.of(), checks -> checks.number("x", Double.POSITIVE_INFINITY))
                        .verdict())
                .isEqualTo(Verdict.PASS);
        assertThat(result(expected, Map.of(), checks -> checks.number("x", 1e300))
                        .verdict())
                .isEqualTo(Verdict.FAIL);
    }

    @Test
    void statistic_givenItsSigma_isWithinSoManyOrNot() {
        assertThat(result(Map.of(), Map.of(), checks -> checks.statistic("x", 1, 1.39, 0.1, 4))
                        .ratio())
                .isCloseTo(0.975, within(1e-12));
        assertThat(result(Map.of(), Map.of(), checks -> checks.statistic("x", 1, 1.41, 0.1, 4))
                        .verdict())
                .isEqualTo(Verdict.FAIL);
        assertThat(result(Map.of(), Map.of(), checks -> checks.statistic("x", 1, Double.NaN, 0.1, 4))
                        .verdict())
                .isEqualTo(Verdict.FAIL);
    }

    @Test
    void numbers_givenAnotherLength_fail() {
        Map<String, ?> expected = Map.of("x", java.util.List.of("1", "2"));
        assertThat(result(expected, Map.of("x_abs", 0.1), checks -> checks.numbers("x", new double[] {1, 2}, "x"))
                        .verdict())
                .isEqualTo(Verdict.PASS);
        assertThat(result(expected, Map.of("x_abs", 0.1), checks -> checks.numbers("x", new double[] {1}, "x"))
                        .verdict())
                .isEqualTo(Verdict.FAIL);
    }

    @Test
    void result_givenSeveralChecks_isThatOfTheWorst() {
        CaseResult result = result(
                Map.of("x", "2.0"),
                Map.of("x_abs", 1e-12),
                checks -> checks.number("x", 2 + 5e-13).holds("rule", false).same("count", 3, 3));
        assertThat(result.verdict()).isEqualTo(Verdict.FAIL);
        assertThat(result.worst().what()).isEqualTo("rule");
        assertThat(result.ratio()).isInfinite();
    }

    @Test
    void result_givenNothingCompared_isRefused() {
        Checks checks = new Checks(TestCases.of("op", Map.of(), Map.of()));
        assertThatThrownBy(() -> checks.result(0)).isInstanceOf(IllegalStateException.class);
        checks.notApplicable("because");
        assertThat(checks.result(0).verdict()).isEqualTo(Verdict.NOT_APPLICABLE);
    }
}
