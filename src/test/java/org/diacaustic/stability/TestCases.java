package org.diacaustic.stability;

import java.util.List;
import java.util.Map;

/** Cases made for tests. */
final class TestCases {
    private TestCases() {}

    static NumericCase of(String operation, Map<String, ?> expected, Map<String, ?> tolerance) {
        return new NumericCase(
                "T-1",
                "TEST",
                "a case",
                operation,
                Values.of("inputs", Map.of()),
                Values.of("expected", expected),
                Values.of("tolerance", tolerance),
                List.of(),
                "");
    }
}
