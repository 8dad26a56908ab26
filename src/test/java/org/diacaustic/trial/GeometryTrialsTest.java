package org.diacaustic.trial;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.diacaustic.parallel.Workers;
import org.diacaustic.stability.CaseFile;
import org.diacaustic.stability.CaseResult;
import org.diacaustic.stability.Launcher;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;
import org.diacaustic.stability.StabilityRun;
import org.diacaustic.stability.Values;
import org.diacaustic.stability.Verdict;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Trials of geometry agree with right answers and with no others. */
class GeometryTrialsTest {
    private final Operations operations = Trials.all(new Launcher(Path.of("java"), List.of(), Optional.empty()));

    /** A case of every operation that takes no long; BVH-04, TRI-06 and the like have a million rays. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "P-REFR-15", "P-REFR-17", "P-REFR-18", "P-SPAWN-02", "P-SPAWN-05", "P-SPAWN-06", "P-SPAWN-07",
                "P-SPHERE-05", "P-SPHERE-07", "P-QUADRIC-02", "P-QUADRIC-10", "P-QUADRIC-12", "P-TRI-02", "P-TRI-04",
                "P-TRI-08", "P-TORUS-01", "P-BVH-01", "P-BVH-03", "P-BVH-06", "P-ACCUM-02", "P-ACCUM-03"
            })
    void trial_givenAnotherAnswer_fails(String id) {
        NumericCase asked = CaseFile.bundled().stream()
                .filter(each -> each.id().equals(id))
                .findFirst()
                .orElseThrow();
        assertThat(run(asked).verdict()).isIn(Verdict.STRETCH, Verdict.PASS);
        NumericCase wrong = new NumericCase(
                asked.id(),
                asked.category(),
                asked.title(),
                asked.operation(),
                asked.inputs(),
                changed(asked.expected()),
                asked.tolerance(),
                asked.acceptable(),
                asked.typicalFailure());
        assertThat(run(wrong).verdict()).as("%s", run(wrong).checks()).isEqualTo(Verdict.FAIL);
    }

    private CaseResult run(NumericCase asked) {
        return new StabilityRun(operations, java.util.Set.of())
                .run(List.of(asked), new Workers(1), result -> {})
                .results()
                .get(0);
    }

    /** Every number a thousandth larger and more, every flag the other one; but as many roots as there are. */
    private static Values changed(Values expected) {
        Map<String, Object> changed = new LinkedHashMap<>();
        for (String key : expected.keys()) {
            changed.put(key, changed(expected, key));
        }
        return Values.of("expected", changed);
    }

    private static Object changed(Values expected, String key) {
        if (key.equals("n")) {
            return expected.decimal(key);
        }
        if (expected.isDecimal(key)) {
            return larger(expected.decimal(key));
        }
        String text = expected.text(key);
        if (text.equals("true") || text.equals("false")) {
            return !Boolean.parseBoolean(text);
        }
        if (!text.startsWith("[")) {
            return text;
        }
        List<Object> changed = new ArrayList<>();
        for (Object item : expected.list(key)) {
            changed.add(
                    item instanceof Boolean flag
                            ? (Object) !flag
                            : item.toString().matches("[-+0-9.eE]+") ? larger(new BigDecimal(item.toString())) : item);
        }
        return changed;
    }

    /** A whole number stays one, so that counts can be read. */
    private static BigDecimal larger(BigDecimal number) {
        boolean whole = number.stripTrailingZeros().scale() <= 0;
        return whole ? number.add(BigDecimal.ONE) : number.add(number.abs().movePointLeft(3));
    }
}
