package org.diacaustic.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The numbers are exact answers for the doubles given, to 20 digits and more. */
class DielectricTest {
    private final Dielectric interfaceOf = new Dielectric();

    @ParameterizedTest(name = "from {0} to {1} at cosine {2}")
    @CsvSource({
        // Just inside the critical angle of glass by 1e-3, 1e-9 and 1e-12 rad.
        "1.5, 1, 0.7460222863775202, 0.04728442118574856, 6.1e-14, 0.7636411878357723, 2.6e-13, 0.2363588121642277, 2.6e-13",
        "1.5, 1, 0.7453559931665966, 4.728708238887197e-5, 6.1e-11, 0.9997251268345782, 3.5e-10, 2.748731654217737e-4, 3.5e-10",
        "1.5, 1, 0.7453559925005966, 1.495372855718395e-6, 1.9e-9, 0.9999913062794525, 1.1e-8, 8.6937205474998e-6, 1.1e-8",
        "1.5, 1, 0.7453559924999306, 4.72400234846536e-8, 9.6e-8, 0.9999997253570935, 5.6e-7, 2.74642906509548e-7, 5.6e-7",
        // Nothing separates equal indices: not even a ghost of a reflection.
        "1.5, 1.5, 0.5, 0.5, 0, 0, 0, 1, 0",
        // Indices that differ by 1e-12: the reflectance is (1e-12 / 2)².
        "1.000000000001, 1, 1, 1, 2.7e-15, 2.50044452266748824e-25, 8.9e-28, 1, 1.8e-15",
        // Ratios beyond those of real glasses.
        "0.1, 1, 0.5, 0.9962429422585638, 1.8e-15, 0.6319066369727562, 1.7e-15, 0.3680933630272438, 1.2e-15",
        "10, 1, 0.999, 0.8944830909525343, 1e-13, 0.6684052304683633, 3.7e-15, 0.3315947695316367, 3.1e-15",
        // Grazing: the transmittance keeps its digits, as one minus the reflectance would not.
        "1, 1.5, 1e-6, 0.7453559925002280, 2.4e-15, 0.9999941862426584, 1.8e-15, 5.813757341550323373e-6, 2e-20",
        "1, 1.5, 1e-9, 0.7453559924999299, 2.4e-15, 0.9999999941862233, 1.8e-15, 5.813776722099453624e-9, 2e-23",
    })
    void evaluate_givenRefraction_splitsThePower(
            double nIncident,
            double nTransmitted,
            double cosIncident,
            double cosTransmitted,
            double cosError,
            double reflectance,
            double reflectanceError,
            double transmittance,
            double transmittanceError) {
        interfaceOf.evaluate(cosIncident, nIncident, nTransmitted);

        assertThat(interfaceOf.totalInternalReflection).isFalse();
        assertThat(interfaceOf.cosTransmitted).isCloseTo(cosTransmitted, within(cosError));
        assertThat(interfaceOf.reflectance).isCloseTo(reflectance, within(reflectanceError));
        assertThat(interfaceOf.transmittance).isCloseTo(transmittance, within(transmittanceError));
    }

    @ParameterizedTest(name = "from {0} to {1} at cosine {2}")
    @CsvSource({
        // Beyond the critical angle of glass by 1e-15, 1e-9 and 1e-3 rad.
        "1.5, 1, 0.7453559924999292",
        "1.5, 1, 0.7453559918332633",
        "1.5, 1, 0.7446889532664092",
        // The critical cosine of an index of 1 + 1e-12 is 1.4e-6.
        "1.000000000001, 1, 1e-6",
        "1.5, 1, 0",
    })
    void evaluate_givenAngleBeyondCritical_reflectsAll(double nIncident, double nTransmitted, double cosIncident) {
        interfaceOf.evaluate(cosIncident, nIncident, nTransmitted);

        assertThat(interfaceOf.totalInternalReflection).isTrue();
        assertThat(interfaceOf.reflectance).isEqualTo(1);
        assertThat(interfaceOf.transmittance).isZero();
        assertThat(interfaceOf.cosTransmitted).isZero();
    }

    @Test
    void evaluate_givenAnyAngle_losesAndGainsNothing() {
        SampleStream random = new SampleStream();
        random.start(1, 0, 0);
        for (int i = 0; i < 100_000; i++) {
            double cosine = i % 2 == 0 ? random.nextDouble() : StrictMath.pow(10, -12 * random.nextDouble());
            double nIncident = 1 + 2 * random.nextDouble();
            double nTransmitted = i % 3 == 0 ? nIncident * (1 + 1e-9 * random.nextDouble()) : 1 + random.nextDouble();
            interfaceOf.evaluate(cosine, nIncident, nTransmitted);

            assertThat(interfaceOf.reflectance + interfaceOf.transmittance)
                    .as("%s from %s to %s", cosine, nIncident, nTransmitted)
                    .isEqualTo(1);
        }
    }

    @Test
    void evaluate_givenTheTransmittedRayBackwards_reflectsTheSameFraction() {
        Dielectric back = new Dielectric();
        for (int i = 1; i <= 1000; i++) {
            double cosine = i / 1000.0;
            interfaceOf.evaluate(cosine, 1, 1.5);
            back.evaluate(interfaceOf.cosTransmitted, 1.5, 1);

            assertThat(back.cosTransmitted).isCloseTo(cosine, within(1e-12));
            assertThat(back.reflectance).isCloseTo(interfaceOf.reflectance, within(1e-11));
        }
    }

    @Test
    void evaluate_givenDiffuseLight_reflectsTheHemisphericalFraction() {
        // ∫ R 2 cosθ d(cosθ) for n = 1.5 from outside is 0.09177795934…, and 1 − Rin = (1 − Rout) / n² from inside.
        assertThat(hemispherical(1, 1.5)).isCloseTo(0.09177795934235121, within(1e-6));
        assertThat(hemispherical(1.5, 1)).isCloseTo(0.59634575970771165, within(1e-6));
    }

    private double hemispherical(double nIncident, double nTransmitted) {
        int n = 200_000;
        double sum = 0;
        for (int i = 0; i < n; i++) {
            double cosine = (i + 0.5) / n;
            interfaceOf.evaluate(cosine, nIncident, nTransmitted);
            sum += 2 * cosine * interfaceOf.reflectance / n;
        }
        return sum;
    }

    @Test
    void normalCoefficient_givenThesisEquation3_needsTheSignedCosine() {
        // I = (sin 30°, −cos 30°), N = (0, 1), into glass: T = (1/3, −√8/3). With the cosine of Eq. 2, which is
        // positive,
        // the same formula would give y = −2.0975.
        double ix = 0.5;
        double iy = -0.8660254037844386;
        interfaceOf.evaluate(-iy, 1, 1.5);
        double tx = interfaceOf.eta * ix;
        double ty = interfaceOf.eta * iy + interfaceOf.normalCoefficient();

        assertThat(tx).isCloseTo(0.3333333333333333478, within(1e-15));
        assertThat(ty).isCloseTo(-0.9428090415820633607, within(1e-15));
        assertThat(Math.hypot(tx, ty)).isCloseTo(1, within(1e-15));
    }
}
