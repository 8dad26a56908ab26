package org.diacaustic.stability;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;

class CaseFileTest {
    private static final String ONE =
            "{\"schema\": \"caustics-numerics/1\", \"cases\": [{\"id\": \"A\", \"category\": \"B\", \"title\": \"C\","
                    + " \"op\": \"d\", \"inputs\": {\"x\": 1e-06, \"f\": \"2/3\", \"i\": \"inf\", \"l\": [1, \"nan\"], \"w\": \"two\"},"
                    + " \"expected\": {}, \"tolerance\": {}}]}";

    private static void refused(String text, String message) {
        assertThatThrownBy(() -> CaseFile.read(text, "file"))
                .isInstanceOf(CaseFileException.class)
                .hasMessageContaining(message)
                .hasMessageNotContaining("\n");
    }

    @Test
    void read_givenWhatIsNoFileOfCases_saysWhere() {
        refused("{\"schema\": ", "file");
        refused("[]", "file should be an object of cases");
        refused("{\"schema\": \"other\"}", "schema should be caustics-numerics/1, but is other");
        refused("{\"schema\": \"caustics-numerics/1\"}", "cases should be a list");
        refused(ONE.replace("\"id\": \"A\"", "\"id\": 5"), "case 1: id should be a text, but is 5");
        refused(
                ONE.replace("\"inputs\": {", "\"inputs\": [{").replace("\"two\"}", "\"two\"}]"),
                "case 1: inputs should be an object");
        String twice = ONE.substring(ONE.indexOf("[{") + 1, ONE.lastIndexOf(']'));
        refused(ONE.replace(twice, twice + ", " + twice), "case 2: the id A is used twice");
    }

    @Test
    void values_givenNumbersOfManyForms_areReadOrNamed() {
        Values inputs = CaseFile.read(ONE, "file").get(0).inputs();
        assertThat(inputs.number("x")).isEqualTo(1e-6);
        assertThat(inputs.number("f")).isEqualTo(2.0 / 3);
        assertThat(inputs.number("i")).isInfinite();
        assertThat(inputs.numbers("l")).containsExactly(1, Double.NaN);
        assertThatThrownBy(() -> inputs.number("w"))
                .isInstanceOf(CaseFault.class)
                .hasMessage("inputs.w should be a number, but is two");
        assertThatThrownBy(() -> inputs.number("y")).hasMessage("the case does not give inputs.y");
        assertThatThrownBy(() -> inputs.vector("l")).hasMessageContaining("three numbers");
        assertThatThrownBy(() -> inputs.integer("x")).hasMessageContaining("a whole number");
    }

    @Test
    void bundled_hasAllCases() {
        List<NumericCase> cases = CaseFile.bundled();
        assertThat(cases).hasSize(249);
        assertThat(cases.stream().map(NumericCase::category).distinct()).hasSize(25);
    }
}
