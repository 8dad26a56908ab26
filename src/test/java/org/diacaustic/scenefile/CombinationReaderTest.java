package org.diacaustic.scenefile;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.diacaustic.shape.Combination;
import org.diacaustic.shape.Sphere;
import org.diacaustic.shape.Transformed;
import org.junit.jupiter.api.Test;

class CombinationReaderTest {
    private static final String BALL = "{sphere: {at: [0, 0, 0], radius: 1}}";

    private final Problems problems = new Problems();

    private Combination read(String kind, String parts) {
        String text = "{camera: {from: [0, 0, 5], to: [0, 0, 0]}, objects: [{" + kind
                + ": {material: {diffuse: 1}, of: [" + parts + "]}}]}";
        return SceneReader.read(SceneDocument.parse("scene", text, problems), problems)
                .map(file -> (Combination) file.scene().objects().get(0).shape())
                .orElse(null);
    }

    @Test
    void read_givenEachKind_combinesItsParts() {
        Combination lens = read("intersection", BALL + ", {sphere: {at: [0, 0, 1], radius: 2}}");
        assertThat(lens.kind()).isEqualTo(Combination.Kind.INTERSECTION);
        assertThat(lens.first()).isInstanceOf(Sphere.class);
        Combination both = read(
                "union", BALL + ", {sphere: {at: [0, 0, 0], radius: 1, transform: [{translate: {by: [2, 0, 0]}}]}}");
        assertThat(both.second()).isInstanceOf(Transformed.class);
        assertThat(both.bounds().maxX()).isGreaterThanOrEqualTo(3);
        assertThat(problems.hasErrors()).isFalse();
    }

    @Test
    void read_givenDifferenceOfThree_takesBothFromTheFirst() {
        Combination bowl = read(
                "difference",
                BALL + ", {sphere: {at: [0, 0, 0], radius: 0.8}}," + " {box: {low: [-1, 0.5, -1], high: [1, 2, 1]}}");
        assertThat(bowl.first()).isInstanceOf(Sphere.class);
        assertThat(((Combination) bowl.second()).kind()).isEqualTo(Combination.Kind.UNION);
    }

    @Test
    void read_givenMany_isNotManyCombinationsDeep() {
        String balls = IntStream.range(0, 1000)
                .mapToObj(i -> "{sphere: {at: [" + i + ", 0, 0], radius: 1}}")
                .collect(Collectors.joining(", "));
        assertThat(read("union", balls).bounds().maxX()).isGreaterThanOrEqualTo(1000);
    }

    @Test
    void read_givenWhatIsNoSolid_saysSoWithItsPlace() {
        read("union", BALL);
        assertThat(problems.toString()).contains("objects[0].union.of: expected a list of at least 2");
        read("union", BALL + ", {plane: {at: [0, 0, 0], normal: [0, 1, 0]}}");
        assertThat(problems.toString()).contains("objects[0].union.of[1]: unknown kind 'plane'");
        read("difference", BALL + ", {cylinder: {from: [0, 0, 0], to: [0, 1, 0], radius: 1, capped: false}}");
        assertThat(problems.toString()).contains("objects[0].difference: shapes of a combination must be closed");
        read("intersection", BALL + ", {sphere: {at: [9, 0, 0], radius: 1}}");
        assertThat(problems.toString()).contains("objects[0].intersection: shapes of an intersection must overlap");
        read("union", BALL + ", {sphere: {at: [0, 0, 0], radius: 1, material: glass}}");
        assertThat(problems.toString()).contains("objects[0].union.of[1].sphere.material: unknown key");
    }
}
