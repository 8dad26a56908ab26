package org.diacaustic.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.diacaustic.study.Technique;
import org.junit.jupiter.api.Test;

class FindingsTest {
    private static final Technique MESH = FakeStudy.known("caustic-mesh");
    private static final Technique LIGHT = FakeStudy.known("light-tracing");
    private static final Technique NEAREST = FakeStudy.known("random-nearest");
    private static final Technique DENSITY = FakeStudy.known("random-density");

    private static List<String> texts(FakeStudy study, Finding.Kind kind) {
        return Findings.of(study.report()).stream()
                .filter(finding -> finding.kind() == kind)
                .map(finding -> finding.text().replace('\u00a0', ' '))
                .toList();
    }

    private static FakeStudy three() {
        return new FakeStudy(4, 0)
                .add(MESH, -1, 0, 100, 1000, 10_000)
                .add(LIGHT, -0.5, 0, 100, 1000, 10_000)
                .add(NEAREST, -0.25, 0, 100, 1000, 10_000);
    }

    @Test
    void of_givenTechniqueThatIsFivePerCentTooBright_exposesIt() {
        FakeStudy study = three().add(DENSITY, -0.5, 0.05, 1000, 10_000, 100_000);
        assertThat(texts(study, Finding.Kind.WRONG))
                .hasSize(1)
                .first()
                .asString()
                .isEqualTo("random-density is 5.00 % too bright at every budget: more rays do not help.");
        assertThat(Findings.of(study.report()).get(0).kind()).isEqualTo(Finding.Kind.WRONG);
    }

    @Test
    void of_givenTechniqueThatIsTooDark_saysSo() {
        assertThat(texts(new FakeStudy(4, 0).add(DENSITY, -0.5, -0.03, 10_000, 100_000), Finding.Kind.WRONG))
                .singleElement()
                .asString()
                .contains("3.00 % too dark");
    }

    @Test
    void of_givenBrightnessThatChanceOrOnePerCentExplains_findsNothingWrong() {
        assertThat(texts(three(), Finding.Kind.WRONG)).isEmpty();
        assertThat(texts(new FakeStudy(4, 0).add(DENSITY, -0.5, 0.009, 10_000, 100_000), Finding.Kind.WRONG))
                .isEmpty();
    }

    @Test
    void of_givenPowers_namesTheBestAtTwoTimes() {
        // Processors take 2.06 µs a ray. Errors at 100 rays are 0.01, 0.1 and 0.32 and at 10,000 rays 0.0001, 0.01 and
        // 0.1, and
        // runs spread them evenly.
        assertThat(texts(three(), Finding.Kind.WINNER))
                .containsExactly(
                        "With 0.21 ms of processors, caustic-mesh has the least error, 1.00 %."
                                + " Next is light-tracing with 10.0 %.",
                        "With 20.6 ms of processors, caustic-mesh has the least error, 0.010 %."
                                + " Next is light-tracing with 1.00 %.");
    }

    @Test
    void of_givenPowers_tellsHowManyTimesLessTimeTheBestTakes() {
        // The mesh has 1 % with 100 rays, light traced to pixels with 10,000; the mesh has less than 10 % at its first
        // point.
        assertThat(texts(three(), Finding.Kind.FASTER))
                .containsExactly(
                        "To an error that both reach, caustic-mesh takes at least 100 times less time than light-tracing"
                                + " (to 1.00 %); at least 100 times less time than random-nearest (to 10.0 %).");
        FakeStudy crossing =
                new FakeStudy(4, 0).add(MESH, -1, 0, 1, 10, 100, 1000).add(LIGHT, -0.5, 0, 1, 10, 100, 1000);
        // 1000^(−1/2) takes 10^1.5 rays of the mesh: 31.6 times fewer.
        assertThat(texts(crossing, Finding.Kind.FASTER))
                .singleElement()
                .asString()
                .contains("takes 31.6 times less time");
    }

    @Test
    void of_givenOneTechnique_comparesNothing() {
        FakeStudy one = new FakeStudy(4, 0).add(MESH, -1, 0, 100, 1000);
        assertThat(texts(one, Finding.Kind.WINNER)).isEmpty();
        assertThat(texts(one, Finding.Kind.FASTER)).isEmpty();
    }

    @Test
    void of_givenErrorsThatStay_saysWhatIsLeft() {
        FakeStudy study = new FakeStudy(4, 0)
                .add(DENSITY, -0.5, 0.005, 1_000_000, 10_000_000, 100_000_000)
                .add(NEAREST, -0.001, 0, 1000, 10_000, 100_000)
                .add(MESH, -1, 0, 100, 1000, 10_000);
        assertThat(texts(study, Finding.Kind.STUCK))
                .hasSize(2)
                .anySatisfy(text ->
                        assertThat(text).contains("random-density (0.50 %").contains("is bias"))
                .anySatisfy(text -> assertThat(text).contains("random-nearest").endsWith("is chance."));
    }

    @Test
    void of_givenErrorsBelowTheReference_doesNotTellThem() {
        // Five times 0.15 % are told: 0.75 %.
        FakeStudy study = new FakeStudy(4, 0.0015)
                .add(MESH, -1, 0, 10, 100, 1000, 10_000)
                .add(LIGHT, -0.5, 0, 10, 100, 1000, 10_000);
        assertThat(texts(study, Finding.Kind.NOTE))
                .containsExactly("The reference tells no error below 0.75 %; 2 of 8 points are below.");
        assertThat(texts(study, Finding.Kind.WINNER)).last().asString().contains("least error, less than 0.75 %");
        assertThat(texts(study, Finding.Kind.STUCK)).isEmpty();
    }

    @Test
    void of_givenSeveralBelowTheReference_namesWhoCameThereFirst() {
        // 5 % with 20 rays and with 400.
        FakeStudy study =
                new FakeStudy(4, 0.01).add(LIGHT, -0.5, 0, 10, 100, 1000).add(MESH, -1, 0, 10, 100, 1000);
        assertThat(texts(study, Finding.Kind.WINNER))
                .last()
                .asString()
                .contains("2 techniques have less error than 5.00 %", "caustic-mesh came so far first");
        assertThat(texts(study, Finding.Kind.FASTER)).singleElement().asString().contains("takes 20.0 times less time");
    }

    @Test
    void of_givenShadingModelsAndRefusals_tellsThem() {
        FakeStudy study = three().refuse(DENSITY, "no lamp").refuse(FakeStudy.known("planar-density"), "no lamp");
        assertThat(texts(study, Finding.Kind.SHADING))
                .containsExactly("The shading model non-transparent, without light traced forward, has an error of"
                        + " 80.0 % and brings 20.0 % of the light that comes over specular surfaces.");
        assertThat(texts(study, Finding.Kind.REFUSED))
                .containsExactly("Refused: random-density, planar-density: no lamp");
    }

    @Test
    void of_givenNothingYet_saysNothingOfTechniques() {
        assertThat(Findings.of(new FakeStudy(4, 0).missing(3).report()))
                .allMatch(finding -> finding.kind() == Finding.Kind.SHADING);
    }
}
