package org.diacaustic.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.stream.Stream;
import org.apache.commons.math3.stat.descriptive.SummaryStatistics;
import org.diacaustic.math.Color;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.SampleStream;
import org.diacaustic.math.Vector3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LightTest {
    private static final Falloff SQUARE = new Falloff.InverseSquare();
    private static final Vector3 DOWN = new Vector3(0, -1, 0);

    private final LightSample sample = new LightSample();

    @Test
    void constructor_givenBadArguments_isRefused() {
        Vector3 nowhere = new Vector3(Double.NaN, 0, 0);
        assertThatIllegalArgumentException().isThrownBy(() -> new PointLight(nowhere, Color.WHITE));
        assertThatIllegalArgumentException().isThrownBy(() -> new PointLight(Vector3.ZERO, Color.grey(-1)));
        assertThatIllegalArgumentException().isThrownBy(() -> new PointLight(Vector3.ZERO, Color.WHITE, SQUARE, -1));
        assertThatIllegalArgumentException().isThrownBy(() -> spot(nowhere, 1, 2));
        assertThatIllegalArgumentException().isThrownBy(() -> spot(Vector3.ZERO, 3, 2));
        assertThatIllegalArgumentException().isThrownBy(() -> spot(Vector3.ZERO, 0, 181));
        assertThatIllegalArgumentException().isThrownBy(() -> new DirectionalLight(Vector3.ZERO, Color.WHITE, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> disc(0, Color.WHITE, SQUARE));
        assertThatIllegalArgumentException().isThrownBy(() -> disc(-1, Color.WHITE, SQUARE));
        assertThatIllegalArgumentException().isThrownBy(() -> disc(1, new Color(0, 0, Double.NaN), SQUARE));
        assertThatIllegalArgumentException()
                .isThrownBy(() ->
                        FlatLight.rectangle(Vector3.ZERO, Vector3.UNIT_X, Vector3.UNIT_X, Color.WHITE, SQUARE, 1));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new SphereLight(Vector3.ZERO, 1, Color.WHITE, SQUARE, 0))
                .withMessageContaining("sample");
        assertThatIllegalArgumentException().isThrownBy(() -> new Falloff.Polynomial(0, 0, 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new Falloff.Polynomial(1, -1, 0));
    }

    @ParameterizedTest
    @CsvSource({
        // Irradiance = flux / (4π d²) · cosine
        "100, 1e-6, 1, 7957747154594.767508650357",
        "100, 1e9, 0.5, 3.978873577297383394e-18",
        "1e30, 2, 1, 1.989436788648691736670e28",
        "1e-30, 2, 1, 1.989436788648691863e-32",
    })
    void sample_givenPointLight_fallsWithTheSquare(double flux, double distance, double cosine, double irradiance) {
        double sine = Math.sqrt(1 - cosine * cosine);
        Vector3 position = new Vector3(sine * distance, cosine * distance, 0);
        Light light = new PointLight(position, Color.grey(flux / (4 * Math.PI)));

        assertThat(light.sample(0, 0, 0, 0, 0, sample)).isTrue();
        assertThat(sample.irradiance.green * sample.directionY).isCloseTo(irradiance, within(irradiance * 1e-14));
        assertThat(sample.distance).isCloseTo(distance, within(distance * 1e-15));
        assertThat(light.sampleCount()).isEqualTo(1);
        assertThat(light.isVisible()).isFalse();
    }

    @Test
    void sample_givenPointAtTheLight_findsNone() {
        assertThat(new PointLight(Vector3.UNIT_X, Color.WHITE).sample(1, 0, 0, 0, 0, sample))
                .isFalse();
        assertThat(spot(Vector3.UNIT_X, 10, 20).sample(1, 0, 0, 0, 0, sample)).isFalse();
        assertThat(disc(1, Color.WHITE, SQUARE).sample(0, 0, 0, 0, 0, sample)).isFalse();
    }

    @Test
    void falloff_givenDistance_isAsDeclared() {
        assertThat(SQUARE.at(4)).isEqualTo(1 / 16.0);
        assertThat(new Falloff.None().at(1e9)).isEqualTo(1);
        assertThat(new Falloff.Polynomial(1, 2, 3).at(2)).isEqualTo(1 / 17.0);
        Light light = new PointLight(new Vector3(0, 2, 0), new Color(17, 34, 51), new Falloff.Polynomial(1, 2, 3), 0);
        assertThat(light.sample(0, 0, 0, 0, 0, sample)).isTrue();
        assertThat(sample.irradiance.toColor()).isEqualTo(new Color(1, 2, 3));
    }

    @Test
    void sample_givenSpot_isFullWithinAndDarkBeyond() {
        // Seen from (x, 0, 0), a spot at height 1 that shines down is at angle atan x.
        SpotLight soft = spot(Vector3.UNIT_Y, 30, 40);
        assertThat(spotIntensity(soft, 29.999)).isCloseTo(1, within(1e-12));
        assertThat(spotIntensity(soft, 40.001)).isZero();
        // Half way between the cosines the smooth step is 1/2.
        double half = (StrictMath.cos(Math.toRadians(30)) + StrictMath.cos(Math.toRadians(40))) / 2;
        assertThat(spotIntensity(soft, Math.toDegrees(StrictMath.acos(half)))).isCloseTo(0.5, within(1e-9));
        SpotLight sharp = spot(Vector3.UNIT_Y, 30, 30);
        assertThat(spotIntensity(sharp, 29.999)).isCloseTo(1, within(1e-12));
        assertThat(spotIntensity(sharp, 30.001)).isZero();
        assertThat(sharp.sample(0, 2, 0, 0, 0, sample)).as("behind").isFalse();
    }

    @Test
    void sample_givenSharpSpot_sendsTheFluxOfItsCone() {
        // 2π (1 − cos 30°) for unit intensity
        double flux = 0;
        int n = 20_000;
        SpotLight spot = spot(Vector3.UNIT_Y, 30, 30);
        for (int i = 0; i < n; i++) {
            double degrees = 180 * (i + 0.5) / n;
            flux += spotIntensity(spot, degrees) * 2 * Math.PI * StrictMath.sin(Math.toRadians(degrees)) * Math.PI / n;
        }
        assertThat(flux).isCloseTo(0.841787214476932925, within(1e-3));
    }

    private double spotIntensity(SpotLight spot, double degrees) {
        double angle = Math.toRadians(degrees);
        // A point at distance 1 from the spot.
        return spot.sample(StrictMath.sin(angle), 1 - StrictMath.cos(angle), 0, 0, 0, sample)
                ? sample.irradiance.red
                : 0;
    }

    @Test
    void sample_givenDirectionalLight_isTheSameEverywhere() {
        // 1000 W·m⁻² from 60° above the horizon of the normal: 500 on the plane.
        Light sun = new DirectionalLight(new Vector3(Math.sqrt(3), -1, 0).times(7), Color.grey(1000), 5);
        for (double x : new double[] {-1e6, 0, 3}) {
            assertThat(sun.sample(x, 0, 0, 0, 0, sample)).isTrue();
            assertThat(sample.irradiance.red * sample.directionY).isCloseTo(500, within(500 * 1e-14));
            assertThat(sample.distance).isEqualTo(Double.POSITIVE_INFINITY);
        }
        assertThat(sun.highlightExponent()).isEqualTo(5);
    }

    @ParameterizedTest
    @CsvSource({
        // A disc of exitance 1, so of radiance 1/π, over a parallel floor: E = r² / (r² + h²) below its centre.
        "0.5, 2, 0.058823529411764706",
        "1e-6, 1, 9.999999999989999095e-13",
    })
    void sample_givenDiscLight_addsUpToTheClosedForm(double radius, double height, double irradiance) {
        Light disc = FlatLight.disc(new Vector3(0, height, 0), DOWN, radius, Color.grey(1 / Math.PI), SQUARE, 1);
        assertUnbiased(disc, Vector3.ZERO, irradiance);
        // By quadrature over the square of choices: the radius is √s, so the integrand is smooth in s.
        assertThat(quadrature(disc, 4000)).isCloseTo(irradiance, within(irradiance * 1e-7));
    }

    @Test
    void sample_givenRectangleLight_addsUpToTheClosedForm() {
        // A rectangle a × b at height h over its corner, parallel: E = L/2 (A/√(1+A²) atan(B/√(1+A²)) + the same with A
        // and B exchanged), A = a/h, B = b/h [Howell, A catalog of radiation heat transfer configuration factors, B-4].
        double a = 2;
        double b = 1;
        double p = Math.sqrt(1 + a * a);
        double q = Math.sqrt(1 + b * b);
        double expected = 0.5 * (a / p * StrictMath.atan(b / p) + b / q * StrictMath.atan(a / q));
        Light light = FlatLight.rectangle(
                new Vector3(0, 1, 0), new Vector3(a, 0, 0), new Vector3(0, 0, b), Color.WHITE, SQUARE, 4);
        assertUnbiased(light, Vector3.ZERO, expected);
        assertThat(light.sampleCount()).isEqualTo(4);
        assertThat(light.sample(0, 2, 0, 0.5, 0.5, sample)).as("from behind").isFalse();
    }

    @Test
    void sample_givenSphereLight_addsUpToTheClosedForm() {
        // E = π L sin²α for a facing surface, α half the angle under which the sphere is seen.
        Light near = new SphereLight(new Vector3(0, 3, 0), 2, Color.grey(5), SQUARE, 1);
        assertUnbiased(near, Vector3.ZERO, Math.PI * 5 * 4 / 9);
        // Tilted by 60°, and wholly above the horizon: half of it.
        Vector3 aside = new Vector3(Math.sqrt(3), 1, 0).times(50);
        Light tilted = new SphereLight(aside, 2, Color.grey(5), SQUARE, 1);
        assertUnbiased(tilted, Vector3.ZERO, Math.PI * 5 * 4 / 10_000 / 2);
        assertThat(near.sample(0, 2, 0, 0.5, 0.5, sample)).as("inside").isFalse();
    }

    @Test
    void sample_givenSphereLight_liesOnItsNearSide() {
        Vector3 centre = new Vector3(1, -2, 3);
        Light light = new SphereLight(centre, 0.5, Color.WHITE, SQUARE, 1);
        SampleStream random = new SampleStream();
        random.start(1, 0, 0);
        for (int i = 0; i < 1000; i++) {
            assertThat(light.sample(0.2, 0.3, 0.1, random.nextDouble(), random.nextDouble(), sample))
                    .isTrue();
            Vector3 direction = new Vector3(sample.directionX, sample.directionY, sample.directionZ);
            Vector3 point = new Vector3(0.2, 0.3, 0.1).plus(direction.times(sample.distance));
            assertThat(direction.length()).isCloseTo(1, within(1e-14));
            assertThat(point.minus(centre).length()).isCloseTo(0.5, within(1e-7));
            assertThat(point.minus(centre).dot(direction)).isLessThanOrEqualTo(1e-7);
        }
    }

    @Test
    void sample_givenAreaLightsWithoutFalloff_isIntensityOverTheWholeArea() {
        // Without falloff a disc is points of intensity L cosθ dA: π r² L cos θ for a small one, at any distance.
        Falloff none = new Falloff.None();
        Light disc = FlatLight.disc(new Vector3(0, 1000, 0), DOWN, 0.1, Color.grey(3), none, 1);
        assertUnbiased(disc, Vector3.ZERO, Math.PI * 0.01 * 3);
        // And so is a sphere, whose cosines add up to its shadow's area.
        Light sphere = new SphereLight(new Vector3(0, 1e6, 0), 0.1, Color.grey(3), none, 1);
        assertUnbiased(sphere, Vector3.ZERO, Math.PI * 0.01 * 3);
    }

    /** The mean of 20,000 samples is within four standard errors of the irradiance on a floor that faces up. */
    private void assertUnbiased(Light light, Vector3 at, double irradiance) {
        SampleStream random = new SampleStream();
        random.start(1, 2, 3);
        SummaryStatistics statistics = new SummaryStatistics();
        for (int i = 0; i < 20_000; i++) {
            boolean shines = light.sample(at.x(), at.y(), at.z(), random.nextDouble(), random.nextDouble(), sample);
            statistics.addValue(shines ? sample.irradiance.red * Math.max(0, sample.directionY) : 0);
        }
        double standardError = statistics.getStandardDeviation() / Math.sqrt(statistics.getN());
        assertThat(statistics.getMean()).isCloseTo(irradiance, within(4 * standardError + irradiance * 1e-6));
        assertThat(standardError).isLessThan(0.01 * irradiance);
    }

    private double quadrature(Light light, int n) {
        double sum = 0;
        for (int i = 0; i < n; i++) {
            light.sample(0, 0, 0, (i + 0.5) / n, 0.3, sample);
            sum += sample.irradiance.red * sample.directionY / n;
        }
        return sum;
    }

    @Test
    void emitsAlong_givenAreaLights_isSeenFromItsBrightSideOnly() {
        Color radiance = new Color(1, 2, 3);
        Light disc = FlatLight.disc(new Vector3(0, 2, 0), DOWN, 0.5, radiance, SQUARE, 1);
        Light skew = FlatLight.rectangle(
                new Vector3(-1, 2, -1), new Vector3(2, 0, 0), new Vector3(1, 0, 2), radiance, SQUARE, 1);
        Light ball = new SphereLight(new Vector3(0, 2, 0), 0.5, radiance, SQUARE, 1);
        assertThat(List.of(disc, skew, ball)).allMatch(Light::isVisible);
        // The disc and the rectangle are 2 above, and the ball's near side is 1.5 above. The rectangle's normal,
        // edgeU × edgeV = (2, 0, 0) × (1, 0, 2) = (0, −4, 0), points down.
        assertThat(distancesSeen(disc, skew, ball)).containsExactly(2.0, 2.0, 1.5);
        assertThat(skew.emitsAlong(ray(0, 4, 0, -1), new Rgb())).isFalse();
        assertThat(disc.emitsAlong(ray(0, 4, 0, -1), new Rgb())).isFalse();
        assertThat(disc.emitsAlong(ray(0.51, 0, 0, 1), new Rgb())).isFalse();
        assertThat(disc.emitsAlong(ray(0.49, 0, 0, 1), new Rgb())).isTrue();
        // At z = 0.9 the rectangle reaches from x = −0.05 to 1.95.
        assertThat(skew.emitsAlong(ray(-0.06, 0, 0.9, 1), new Rgb())).isFalse();
        assertThat(skew.emitsAlong(ray(1.94, 0, 0.9, 1), new Rgb())).isTrue();
        assertThat(ball.emitsAlong(ray(0, 2, 0, 1), new Rgb())).as("inside").isFalse();
        // Behind something nearer it is hidden.
        Ray shortened = ray(0, 0, 0, 1);
        shortened.tMax = 1;
        assertThat(disc.emitsAlong(shortened, new Rgb())).isFalse();
        Rgb seen = new Rgb();
        ball.emitsAlong(ray(0, 0, 0, 1), seen);
        assertThat(seen.toColor()).isEqualTo(radiance);
    }

    private static List<Double> distancesSeen(Light... lights) {
        return Stream.of(lights)
                .map(light -> {
                    Ray ray = ray(0, 0, 0, 1);
                    assertThat(light.emitsAlong(ray, new Rgb())).isTrue();
                    return ray.tMax;
                })
                .toList();
    }

    private static Ray ray(double x, double y, double z, double up) {
        Ray ray = new Ray();
        ray.set(x, y, z, 0, up, 0);
        return ray;
    }

    private static SpotLight spot(Vector3 position, double inner, double outer) {
        return new SpotLight(position, DOWN, inner, outer, Color.WHITE, SQUARE, 0);
    }

    private static FlatLight disc(double radius, Color radiance, Falloff falloff) {
        return FlatLight.disc(Vector3.ZERO, Vector3.UNIT_Y, radius, radiance, falloff, 1);
    }

    @ParameterizedTest
    @CsvSource({
        // 4π·sin² of half the angle: of a millionth of a degree, a cosine tells nothing.
        "1e-6, 1e-6, 9.569838481574017e-16",
        "30, 30, 0.841787214476932925",
        "180, 180, 12.566370614359172954",
        // π·((1 − cos 0°) + (1 − cos 60°)): the step stands for half of what it fills.
        "0, 60, 1.5707963267948966",
    })
    void flux_givenSpot_isThatOfItsCone(double inner, double outer, double flux) {
        SpotLight spot = spot(Vector3.ZERO, inner, outer);
        assertThat(spot.flux().green()).isCloseTo(flux, within(4e-16 * flux));
    }

    @Test
    void flux_givenSoftSpot_isTheIntegralOfItsEmission() {
        SpotLight spot = spot(Vector3.ZERO, 20, 75);
        Rgb out = new Rgb();
        double sum = 0;
        int steps = 200_000;
        for (int i = 0; i < steps; i++) {
            double down = 1 - 2 * (i + 0.5) / steps;
            spot.emit(new LightPoint(), Math.sqrt(1 - down * down), -down, 0, out);
            sum += out.green * 4 * Math.PI / steps;
        }
        assertThat(sum).isCloseTo(spot.flux().green(), within(1e-9));
    }

    @Test
    void flux_givenOtherLights_isThatOfTheirArea() {
        // π·L·A of what radiates as Lambert says; 4π·I of a point.
        assertThat(disc(2, Color.WHITE, SQUARE).flux().green()).isCloseTo(Math.PI * Math.PI * 4, within(1e-14));
        assertThat(new SphereLight(Vector3.ZERO, 3, Color.WHITE, SQUARE, 1)
                        .flux()
                        .red())
                .isCloseTo(4 * Math.PI * Math.PI * 9, within(1e-12));
        assertThat(new PointLight(Vector3.ZERO, Color.grey(2)).flux().blue()).isEqualTo(8 * Math.PI);
        DirectionalLight sun = new DirectionalLight(DOWN, Color.WHITE, 0);
        org.assertj.core.api.Assertions.assertThatThrownBy(sun::flux).isInstanceOf(UnsupportedOperationException.class);
    }

    @Test
    void emit_givenNarrowestSpot_shinesToItsEdgeAndNoFarther() {
        SpotLight spot = spot(Vector3.ZERO, 1e-6, 1e-6);
        double edge = Math.toRadians(1e-6);
        Rgb out = new Rgb();
        spot.emit(new LightPoint(), edge * (1 - 1e-9), -1, 0, out);
        assertThat(out.green).isEqualTo(1);
        spot.emit(new LightPoint(), edge * (1 + 1e-9), -1, 0, out);
        assertThat(out.green).isZero();
    }
}
