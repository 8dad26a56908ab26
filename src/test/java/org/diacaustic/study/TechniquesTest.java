package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TechniquesTest {

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    planar            | unknown technique 'planar'; known are caustic-mesh, light-tracing
                    ''                | unknown technique ''
                    mine:map          | technique 'mine': expected key=value, found 'map'
                    a/b:map=none      | must be of letters, digits, '-', '_' and '.', but is 'a/b'
                    :map=none         | but is ''
                    :                 | but is ''
                    progressive,progressive | two techniques are named 'progressive'
                    """)
    void parse_givenWhatIsNoList_saysWhy(String text, String why) {
        assertThatThrownBy(() -> Techniques.parse(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(why);
    }

    @Test
    void parse_givenNamesAndOnesOwn_keepsTheirOrder() {
        List<Technique> techniques =
                Techniques.parse("progressive, mine:map=photon-map:gather-count=200,light-tracing");
        assertThat(techniques).extracting(Technique::name).containsExactly("progressive", "mine", "light-tracing");
        assertThat(techniques.get(1).settings()).containsOnly(entry("map", "photon-map"), entry("gather-count", "200"));
        assertThat(techniques.get(1).way()).isEqualTo(Technique.Way.OVER_A_MAP);
        assertThat(techniques.get(2).way()).isEqualTo(Technique.Way.INTO_PIXELS);
    }

    @Test
    void overrides_givenAShader_keepIt() {
        Technique straight =
                Techniques.parse("straight:shader=non-refractive:map=none").get(0);
        assertThat(straight.overrides())
                .containsEntry("shader", "non-refractive")
                .containsEntry("clamp", "false");
    }

    private static java.util.Map.Entry<String, String> entry(String key, String value) {
        return java.util.Map.entry(key, value);
    }
}
