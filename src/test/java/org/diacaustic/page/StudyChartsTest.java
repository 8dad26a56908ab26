package org.diacaustic.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import org.diacaustic.study.Techniques;
import org.junit.jupiter.api.Test;
import org.xml.sax.InputSource;

class StudyChartsTest {
    private static final long[] RAYS = {1_000, 10_000, 100_000};

    private static FakeStudy three() {
        return new FakeStudy(4, 0.0001)
                .add(FakeStudy.known("caustic-mesh"), -0.9, 0, RAYS)
                .add(FakeStudy.known("random-nearest"), -0.4, 0, RAYS)
                .add(FakeStudy.known("planar-expected-count"), -0.4, 0.05, RAYS);
    }

    private static FakeStudy everything() {
        FakeStudy fake = new FakeStudy(4, 0.001);
        Techniques.known().forEach(technique -> fake.add(technique, -0.4, 0, RAYS));
        return fake;
    }

    private static long count(String text, String part) {
        return Pattern.compile(Pattern.quote(part)).matcher(text).results().count();
    }

    @Test
    void files_givenAnyStudy_areDrawingsThatStandAlone() throws Exception {
        for (FakeStudy fake : List.of(three(), everything())) {
            for (Map.Entry<String, String> file :
                    StudyCharts.files(fake.report()).entrySet()) {
                assertThat(file.getKey()).endsWith(".svg");
                assertThat(file.getValue())
                        .doesNotContain("NaN")
                        .doesNotContain("Infinity")
                        .doesNotContain("class=\"fill");
                var document = DocumentBuilderFactory.newInstance()
                        .newDocumentBuilder()
                        .parse(new InputSource(new StringReader(file.getValue())));
                assertThat(document.getDocumentElement().getTagName()).isEqualTo("svg");
            }
        }
    }

    @Test
    void files_givenNothingYet_areNone() {
        assertThat(StudyCharts.files(new FakeStudy(4, 0).missing(5).report())).isEmpty();
    }

    @Test
    void files_givenFewTechniques_haveAllInOneChart() {
        Map<String, String> files = StudyCharts.files(three().report());
        assertThat(files.keySet()).noneMatch(name -> name.startsWith("family"));
        assertThat(files.get("error-processor.svg"))
                .contains(">caustic-mesh<", ">random-nearest<", ">planar-expected-count<", ">shader non-transparent<");
    }

    @Test
    void files_givenAllTechniques_haveAChartAFamilyAndOneOfTheBest() {
        Map<String, String> files = StudyCharts.files(everything().report());
        assertThat(files.keySet())
                .contains("family-nearest.svg", "family-caustic-mesh.svg", "family-ambient-maps.svg")
                .filteredOn(name -> name.startsWith("family"))
                .hasSize(7);
        assertThat(count(files.get("error-processor.svg"), "<g class=\"line\">"))
                .isEqualTo(7);
        assertThat(count(files.get("family-nearest.svg"), "<g class=\"line\">")).isEqualTo(5);
    }

    @Test
    void error_givenErrorsBelowTheReferences_drawsThemHollow() {
        // With 10⁵ rays the mesh comes to 10^-4.5, below the reference's 0.001 × 5; so it does with 10⁴, and not with
        // 10³.
        String chart = StudyCharts.files(three().report()).get("error-processor.svg");
        String mesh = chart.substring(chart.indexOf("<title>caustic-mesh<"), chart.indexOf(">caustic-mesh</text>"));
        assertThat(count(mesh, "fill=\"" + Palette.PAPER + "\"")).isEqualTo(2);
        assertThat(mesh).contains("at most");
        assertThat(chart).contains("own error × 5");
        String other =
                chart.substring(chart.indexOf("<title>random-nearest<"), chart.indexOf(">random-nearest</text>"));
        assertThat(other).doesNotContain("fill=\"" + Palette.PAPER + "\"").contains("fill-opacity");
    }

    @Test
    void error_givenLinesThatEndTogether_keepsNamesApart() {
        String chart = StudyCharts.files(everything().report()).get("error-processor.svg");
        List<Double> feet = new ArrayList<>();
        for (MatchResult match : Pattern.compile("y=\"([\\d.]+)\" font-size=\"13.5\" fill=\"" + Palette.TEXT + "\">")
                .matcher(chart)
                .results()
                .toList()) {
            feet.add(Double.parseDouble(match.group(1)));
        }
        feet.sort(null);
        assertThat(feet).hasSize(7);
        for (int i = 1; i < feet.size(); i++) {
            assertThat(feet.get(i) - feet.get(i - 1)).isGreaterThan(13.5);
        }
    }

    @Test
    void brightness_givenOneThatIsTooBright_drawsItAsWrong() {
        Map<String, String> files = StudyCharts.files(three().report());
        String chart = files.get("brightness.svg");
        assertThat(count(chart, "fill=\"" + Palette.WRONG + "\" text-anchor=\"end\" font-weight=\"bold\""))
                .isEqualTo(2);
        assertThat(chart.replace('\u00a0', ' ')).contains("planar-expected-count: +5.00 %, the true mean +4.");
    }

    @Test
    void style_givenEveryColour_hasAnotherInTheDark() throws Exception {
        String style =
                new String(StudyPage.class.getResourceAsStream("study.css").readAllBytes(), StandardCharsets.UTF_8);
        List<String> colors = new ArrayList<>(Palette.LINES);
        colors.addAll(List.of(Palette.PAPER, Palette.TEXT, Palette.MUTED, Palette.RULE, Palette.BEHIND, Palette.WRONG));
        for (String color : colors) {
            assertThat(style).contains("[fill=\"" + color + "\"]", "[stroke=\"" + color + "\"]");
        }
    }
}
