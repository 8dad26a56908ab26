package org.diacaustic.fault;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigDecimal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class StrictJsonTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "NaN",
                "[NaN]",
                "{\"a\": Infinity}",
                "[1,]",
                "[1 2]",
                "{\"a\": 1,}",
                "{a: 1}",
                "{\"a\" 1}",
                "{\"a\": 1, \"a\": 2}",
                "[01]",
                "[+1]",
                "[1.]",
                "[.5]",
                "[1",
                "\"\t\"",
                "\"\\x\"",
                "1 2"
            })
    void values_givenWhatIsNotJson_throws(String text) {
        assertThatThrownBy(() -> StrictJson.values(text)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void values_givenJson_givesValuesByPath() {
        assertThat(StrictJson.values(
                        " {\"a\": [1.50, {\"b\": \"\\u00e9\\n\"}], \"c\": null, \"d\": true, \"e\": {}, \"f\": []} "))
                .hasSize(4)
                .containsEntry("/a/0", new BigDecimal("1.50"))
                .containsEntry("/a/1/b", "\u00e9\n")
                .containsEntry("/c", null)
                .containsEntry("/d", true);
    }
}
