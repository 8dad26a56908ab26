package org.diacaustic.material;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.diacaustic.image.LinearImage;
import org.diacaustic.math.Color;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.SampleStream;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.PlanarMapping;
import org.junit.jupiter.api.Test;

class TextureTest {
    private final Rgb color = new Rgb();

    @Test
    void constructor_givenBadArguments_isRefused() {
        assertThatIllegalArgumentException().isThrownBy(() -> new Pattern.Checker(0));
        assertThatIllegalArgumentException().isThrownBy(() -> new Pattern.MapChecker(0, 1));
        assertThatIllegalArgumentException().isThrownBy(() -> new Pattern.Stripes(Vector3.ZERO, 1));
        assertThatIllegalArgumentException().isThrownBy(() -> new Pattern.Marble(1, -1));
        assertThatIllegalArgumentException().isThrownBy(() -> new Pattern.Clouds(Double.NaN));
        assertThatIllegalArgumentException().isThrownBy(() -> new ImageTexture(new LinearImage(1, 1), 1, 0));
    }

    @Test
    void builder_givenImpossibleCoefficients_isRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Material.builder().diffuse(Color.grey(1.1)))
                .withMessageContaining("diffuse");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Material.builder().transparency(new Color(0.5, -0.1, 0)))
                .withMessageContaining("transparency");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Material.builder()
                        .reflectivity(Color.grey(0.6))
                        .transparency(Color.grey(0.5))
                        .build())
                .withMessageContaining("1.1");
        assertThatIllegalArgumentException().isThrownBy(() -> Medium.of(0));
        assertThatIllegalArgumentException().isThrownBy(() -> new Medium(1.5, Color.grey(-1), 0));
        assertThatIllegalArgumentException().isThrownBy(() -> new Medium(1.5, Color.BLACK, -1));
    }

    @Test
    void checker_givenNeighbouringCubes_alternatesWithTheirEdge() {
        Pattern checker = new Pattern.Checker(0.5);
        assertThat(checker.at(at(0.1, 0, 0.1))).isZero();
        for (int i = -4; i <= 4; i++) {
            double odd = Math.floorMod(i, 2);
            assertThat(checker.at(at(0.1 + 0.5 * i, 0, 0.1))).isEqualTo(odd);
            assertThat(checker.at(at(0.1, 0.5 * i, 0.1))).isEqualTo(odd);
            assertThat(checker.at(at(0.1, 0, 0.1 + 0.5 * i))).isEqualTo(odd);
        }
        // A floor at height 0 lies in the middle of a layer.
        assertThat(checker.at(at(0.1, 1e-9, 0.1))).isEqualTo(checker.at(at(0.1, -1e-9, 0.1)));
    }

    @Test
    void mapChecker_givenColumnsAndRows_alternatesWithThem() {
        Pattern checker = new Pattern.MapChecker(4, 2);
        assertThat(checker.at(mapped(0.1, 0.1))).isZero();
        assertThat(checker.at(mapped(0.3, 0.1))).isEqualTo(1);
        assertThat(checker.at(mapped(0.1, 0.6))).isEqualTo(1);
        assertThat(checker.at(mapped(0.3, 0.6))).isZero();
        assertThat(checker.needsMap()).isTrue();
    }

    @Test
    void stripes_givenOneLength_runThroughBothColours() {
        Texture stripes = new PatternTexture(
                new Pattern.Stripes(new Vector3(0, 0, 2), 0.5), new Color(1, 0, 0), new Color(0, 0, 1));
        assertColor(stripes, at(3, 4, 0), 1, 0, 0);
        assertColor(stripes, at(3, 4, 0.25), 0, 0, 1);
        assertColor(stripes, at(3, 4, 0.125), 0.5, 0, 0.5);
        assertColor(stripes, at(3, 4, 0.5), 1, 0, 0);
    }

    @Test
    void marble_givenNoTurbulence_isBandsAndWithItStaysWithinBothColours() {
        Pattern bands = new Pattern.Marble(2, 0);
        assertThat(bands.at(at(0.3, 0, 0.9))).isZero();
        assertThat(bands.at(at(0.3, 1, 0.9))).isEqualTo(1);

        SampleStream random = new SampleStream();
        random.start(1, 0, 0);
        Pattern marble = new Pattern.Marble(2, 3);
        Pattern clouds = new Pattern.Clouds(2);
        double smallest = 1;
        double largest = 0;
        for (int i = 0; i < 1000; i++) {
            Hit hit = at(20 * random.nextDouble(), 20 * random.nextDouble() - 10, 20 * random.nextDouble());
            assertThat(marble.at(hit)).isBetween(0.0, 1.0);
            smallest = Math.min(smallest, clouds.at(hit));
            largest = Math.max(largest, clouds.at(hit));
        }
        assertThat(smallest).isBetween(0.0, 0.3);
        assertThat(largest).isBetween(0.7, 1.0);
    }

    @Test
    void marble_givenLatticePlanes_isContinuousAcrossThem() {
        Pattern marble = new Pattern.Marble(1, 2);
        for (int i = -3; i <= 3; i++) {
            assertThat(marble.at(at(i + 1e-9, 0.3, 0.4))).isCloseTo(marble.at(at(i - 1e-9, 0.3, 0.4)), within(1e-6));
            assertThat(marble.at(at(0.3, 0.4, i + 1e-9))).isCloseTo(marble.at(at(0.3, 0.4, i - 1e-9)), within(1e-6));
        }
    }

    @Test
    void patterns_givenSceneScaledByPowersOfTwo_areTheSameToTheBit() {
        for (double k : new double[] {0x1p20, 0x1p-20}) {
            Hit here = at(1.37, -0.81, 5.3);
            Hit there = at(1.37 * k, -0.81 * k, 5.3 * k);
            Vector3 along = new Vector3(1, 2, 3);
            assertThat(new Pattern.Checker(0.3 * k).at(there)).isEqualTo(new Pattern.Checker(0.3).at(here));
            assertThat(new Pattern.Stripes(along, 0.3 * k).at(there))
                    .isEqualTo(new Pattern.Stripes(along, 0.3).at(here));
            assertThat(new Pattern.Marble(0.3 * k, 2).at(there)).isEqualTo(new Pattern.Marble(0.3, 2).at(here));
            assertThat(new Pattern.Clouds(0.3 * k).at(there)).isEqualTo(new Pattern.Clouds(0.3).at(here));
        }
    }

    @Test
    void image_givenMiddlesOfTexels_isTheirColour() {
        // Row 0 is at the top, where v is 1.
        Texture texture = new ImageTexture(numbered(4, 2), 1, 1);
        for (int x = 0; x < 4; x++) {
            for (int y = 0; y < 2; y++) {
                assertColor(texture, mapped((x + 0.5) / 4, 1 - (y + 0.5) / 2), 10 * y + x, 0, 1);
            }
        }
        assertThat(texture.needsMap()).isTrue();
    }

    @Test
    void image_givenPointsBetween_isBilinear() {
        Texture texture = new ImageTexture(numbered(4, 2), 1, 1);
        // A quarter of the way from texel (1, 0) to (2, 0), and half way down to the row below.
        assertColor(texture, mapped(1.75 / 4, 0.5), 1.25 + 5, 0, 1);
    }

    @Test
    void image_givenBorders_goesRoundInUAndStopsInV() {
        Texture texture = new ImageTexture(numbered(4, 2), 1, 1);
        // Half way between the last column, 3, and the first, 0.
        assertColor(texture, mapped(0, 0.75), 1.5, 0, 1);
        assertColor(texture, mapped(1, 0.75), 1.5, 0, 1);
        assertColor(texture, mapped(1 - 1e-17, 0.75), 1.5, 0, 1);
        assertColor(texture, mapped(0.125, 1), 0, 0, 1);
        assertColor(texture, mapped(0.125, 0), 10, 0, 1);
        assertColor(texture, mapped(0.125, -0.0), 10, 0, 1);
    }

    @Test
    void image_givenRepeats_startsAgain() {
        Texture texture = new ImageTexture(numbered(4, 2), 2, 3);
        assertColor(texture, mapped((2.5 + 4) / 8, 1 - (1.5 + 4) / 6), 12, 0, 1);
        // At the top the row above is the last one of the copy before.
        assertColor(texture, mapped(0.5 / 8, 1), 5, 0, 1);
    }

    @Test
    void mapped_givenMappingOfItsOwn_leavesTheShapesMapToTheOthers() {
        Texture own = new MappedTexture(
                new ImageTexture(numbered(4, 2), 1, 1),
                new PlanarMapping(Vector3.ZERO, new Vector3(8, 0, 0), new Vector3(0, 0, 8)));
        Hit hit = at(5, 0, 6);
        hit.setMap(0.125, 0.25);
        hit.setTangents(1, 2, 3, 4, 5, 6);

        // (5, 6) of 8 × 8 is the middle of texel (2, 0).
        assertColor(own, hit, 2, 0, 1);
        assertThat(own.needsMap()).isFalse();
        assertThat(hit.u).isEqualTo(0.125);
        assertThat(hit.v).isEqualTo(0.25);
        assertThat(hit.tangentUY).isEqualTo(2);
        assertThat(hit.tangentVZ).isEqualTo(6);
    }

    @Test
    void transmittance_givenAbsorption_isBeersLaw() {
        assertThat(Medium.transmittance(0.7, 3)).isCloseTo(0.1224564282529819, within(1e-15));
        assertThat(Medium.transmittance(10_000, 1)).isZero();
        assertThat(Medium.transmittance(745, 1)).isEqualTo(Double.MIN_VALUE);
        assertThat(Medium.transmittance(1e-20, 1)).isEqualTo(1);
        // Nothing absorbs nothing, however far.
        assertThat(Medium.transmittance(0, Double.POSITIVE_INFINITY)).isEqualTo(1);
        assertThat(Medium.transmittance(0.1, Double.POSITIVE_INFINITY)).isZero();
    }

    private void assertColor(Texture texture, Hit hit, double red, double green, double blue) {
        texture.evaluate(hit, color);
        assertThat(color.red).isCloseTo(red, within(1e-13));
        assertThat(color.green).isCloseTo(green, within(1e-13));
        assertThat(color.blue).isCloseTo(blue, within(1e-13));
    }

    /** Texel (x, y) is red 10 y + x. */
    private static LinearImage numbered(int width, int height) {
        LinearImage image = new LinearImage(width, height);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                image.set(x, y, 10 * y + x, 0, 1);
            }
        }
        return image;
    }

    private static Hit at(double x, double y, double z) {
        Hit hit = new Hit();
        hit.setPoint(x, y, z, 0);
        hit.setNormal(0, 1, 0);
        return hit;
    }

    private static Hit mapped(double u, double v) {
        Hit hit = at(0, 0, 0);
        hit.setMap(u, v);
        return hit;
    }
}
