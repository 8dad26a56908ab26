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
                    planar            | unknown technique 'planar'; known are caustic-mesh, planar-caustic-mesh
                    ''                | unknown technique ''
                    mine:map          | technique 'mine': expected key=value, found 'map'
                    a/b:map=none      | must be of letters, digits, '-', '_' and '.', but is 'a/b'
                    :map=none         | but is ''
                    :                 | but is ''
                    planar-density,planar-density | two techniques are named 'planar-density'
                    *-density,cube-*  | two techniques are named 'cube-density'
                    *-desnity         | unknown technique '*-desnity'
                    """)
    void parse_givenWhatIsNoList_saysWhy(String text, String why) {
        assertThatThrownBy(() -> Techniques.parse(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(why);
    }

    @Test
    void parse_givenNamesAndOnesOwn_keepsTheirOrder() {
        List<Technique> techniques =
                Techniques.parse("planar-progressive, mine:map=photon-map:gather-count=200,light-tracing");
        assertThat(techniques)
                .extracting(Technique::name)
                .containsExactly("planar-progressive", "mine", "light-tracing");
        assertThat(techniques.get(1).settings()).containsOnly(entry("map", "photon-map"), entry("gather-count", "200"));
        assertThat(techniques.get(1).way()).isEqualTo(Technique.Way.OVER_A_MAP);
        assertThat(techniques.get(2).way()).isEqualTo(Technique.Way.INTO_PIXELS);
    }

    @Test
    void parse_givenAStar_findsAllThatFit() {
        assertThat(Techniques.parse("*-caustic-mesh,light-tracing"))
                .extracting(Technique::name)
                .containsExactly("planar-caustic-mesh", "cube-caustic-mesh", "adaptive-caustic-mesh", "light-tracing");
    }

    @Test
    void known_givenTheThesisAndOurs_areAllThatGoTogether() {
        // Five ways to choose rays with four estimators and ambient maps; four meshes; light tracing.
        assertThat(Techniques.known()).hasSize(5 * 5 + 4 + 1).doesNotHaveDuplicates();
        assertThat(Techniques.known()).extracting(Technique::family).contains("expected-count", "ambient-maps");
        assertThat(Techniques.quick()).hasSize(8);
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
