package org.diacaustic.json;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.Locale;
import org.junit.jupiter.api.Test;

class JsonWriterTest {
    private final JsonWriter json = new JsonWriter();

    @Test
    void misuse_givenCallsThatMakeNoJson_throws() {
        assertThatIllegalStateException().isThrownBy(json::toString);
        assertThatIllegalStateException().isThrownBy(json::end);
        assertThatIllegalStateException().isThrownBy(() -> json.name("a"));
        json.beginObject();
        assertThatIllegalStateException().isThrownBy(() -> json.value(1));
        assertThatIllegalStateException().isThrownBy(json::toString);
        json.name("a");
        assertThatIllegalStateException().isThrownBy(json::end);
        assertThatIllegalStateException().isThrownBy(() -> json.name("b"));
        json.beginArray();
        assertThatIllegalStateException().isThrownBy(() -> json.name("b"));
        json.end().end();
        assertThatIllegalStateException().isThrownBy(() -> json.value(1));
    }

    @Test
    void toString_givenNestedValues_isIndented() {
        json.beginObject()
                .put("seed", 7)
                .name("size")
                .beginArray()
                .value(2)
                .value(1.5)
                .end();
        json.name("none").beginObject().end().put("done", true).end();

        assertThat(json).hasToString("""
                {
                  "seed": 7,
                  "size": [
                    2,
                    1.5
                  ],
                  "none": {},
                  "done": true
                }
                """);
    }

    @Test
    void value_givenAnyLocale_writesPointsAndPlainDigits() {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.GERMANY);
            assertThat(json.beginArray().value(1234567.5).value(1234567L).end().toString())
                    .contains("1234567.5")
                    .contains("1234567\n");
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void document_givenExtremeValues_isReadBackByAnIndependentParser() throws IOException {
        StringBuilder all = new StringBuilder();
        for (char c = 0; c < 300; c++) {
            all.append(c);
        }
        String text = all + "\u2028\ud83d\ude00\"\\/";
        json.beginObject();
        json.put("nan", Double.NaN).put("infinity", Double.NEGATIVE_INFINITY);
        json.put("smallest", Double.MIN_VALUE).put("largest", -Double.MAX_VALUE).put("zero", -0.0);
        json.put("long", Long.MIN_VALUE)
                .put(text, text)
                .put("absent", (String) null)
                .put("half", "a\ud83d");
        JsonNode read = new ObjectMapper().readTree(json.end().toString());

        assertThat(read.get("nan").isNull()).isTrue();
        assertThat(read.get("infinity").isNull()).isTrue();
        assertThat(read.get("smallest").doubleValue()).isEqualTo(Double.MIN_VALUE);
        assertThat(read.get("largest").doubleValue()).isEqualTo(-Double.MAX_VALUE);
        assertThat(Double.doubleToRawLongBits(read.get("zero").doubleValue())).isEqualTo(Long.MIN_VALUE);
        assertThat(read.get("long").longValue()).isEqualTo(Long.MIN_VALUE);
        assertThat(read.get(text).textValue()).isEqualTo(text);
        assertThat(read.get("absent").isNull()).isTrue();
        assertThat(read.get("half").textValue()).isEqualTo("a\ud83d");
    }
}
