package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

class ExpectationTest {

    private static Expectation of(String name) {
        return Expectation.of(Techniques.parse(name).get(0));
    }

    private static java.util.List<Technique> known() {
        return Techniques.known();
    }

    @ParameterizedTest
    @MethodSource("known")
    void of_givenAnyKnownTechnique_saysSomethingOfItsOwn(Technique technique) {
        assertThat(Expectation.of(technique).says()).isNotEmpty().doesNotContain("no expectation");
    }

    @ParameterizedTest
    @CsvSource({
        "light-tracing, -0.5, -1",
        "random-density, 0, -1",
        "random-nearest, 0, 0",
        "random-progressive, -0.3333333333333333, -0.6666666666666666",
        "random-expected-count, 0, -1"
    })
    void of_givenRandomRays_namesPowers(String name, double error, double variance) {
        assertThat(of(name).errorPower()).isEqualTo(OptionalDouble.of(error));
        assertThat(of(name).variancePower()).isEqualTo(OptionalDouble.of(variance));
    }

    @Test
    void of_givenLattice_namesNoPowerOfItsChance() {
        assertThat(of("planar-progressive").variancePower()).isEmpty();
        assertThat(of("planar-progressive").squaredBiasPower()).hasValue(-2.0 / 3);
        assertThat(of("planar-progressive").says()).contains("less chance");
        // What stays is bias, whichever the rays.
        assertThat(of("planar-density").errorPower()).hasValue(0);
    }

    @Test
    void of_givenFixedPasses_doesNotExpectTheRadiusToShrinkFurther() {
        Expectation expectation = of("mine:preprocessor=random:map=photon-map:estimator=progressive:passes=4");
        assertThat(expectation.errorPower()).hasValue(0);
    }

    @Test
    void of_givenMorePhotonsToGather_expectsLessChance() {
        // √(4/3 ÷ 50) = 16.3 %, √(4/3 ÷ 400) = 5.8 %.
        assertThat(of("random-nearest").says()).contains("50 photons", "16 %");
        assertThat(of("mine:preprocessor=random:map=photon-map:estimator=nearest:gather-count=400")
                        .says())
                .contains("400 photons", "6 %");
    }

    @Test
    void of_givenSettingsLeftOpen_expectsNothing() {
        Technique open = new Technique("open", Technique.Way.OVER_A_MAP, Map.of(), 0);
        assertThat(Expectation.of(open).errorPower()).isEmpty();
        assertThat(Expectation.of(open).says()).contains("no expectation");
    }
}
