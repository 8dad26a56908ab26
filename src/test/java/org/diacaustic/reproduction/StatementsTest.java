package org.diacaustic.reproduction;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import org.diacaustic.image.LinearImage;
import org.junit.jupiter.api.Test;

/** Verdicts follow the numbers: each is turned round by numbers that say the opposite. */
class StatementsTest {

    @Test
    void judge_givenOneScene_leavesWhatNeedsOthersUntested() {
        List<Verdict> verdicts = judge(published(), List.of(ThesisScene.CONTROL));
        assertThat(verdict(verdicts, 3).finding()).isEqualTo(Finding.CONFIRMED);
        assertThat(verdict(verdicts, 2).finding()).isEqualTo(Finding.NOT_TESTED);
        assertThat(verdict(verdicts, 2).evidence()).isEqualTo("needs the scene complex");
        assertThat(verdict(verdicts, 4).evidence()).isEqualTo("needs the scene complex and refraction");
    }

    @Test
    void judge_givenTheThesisOwnNumbers_confirmsWhatItConcludesFromThem() {
        List<Verdict> verdicts = judge(published(), List.of(ThesisScene.values()));
        assertThat(verdicts.stream().map(v -> v.statement().number()))
                .containsExactly(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14);
        for (int number : new int[] {1, 2, 3, 4, 8, 10, 11}) {
            assertThat(verdict(verdicts, number).finding())
                    .as(verdict(verdicts, number).statement().claim())
                    .isEqualTo(Finding.CONFIRMED);
        }
        assertThat(verdict(verdicts, 2).evidence()).isEqualTo("31,336 tests fewer, 1.4 %");
        assertThat(verdict(verdicts, 8).evidence()).isEqualTo("stores 1.12 times as much with 3.16 times the rays");
    }

    @Test
    void judge_givenOppositeNumbers_contradicts() {
        BiFunction<Experiment, Quantity, Double> opposite = (experiment, quantity) -> {
            double value = published().apply(experiment, quantity);
            boolean planar = experiment.method() == Method.PLANAR;
            return switch (quantity) {
                case EYE_TESTS -> experiment.method() == Method.NON_REFRACTIVE ? value - 1e6 : value;
                case LIGHT_TESTS -> planar ? 1e12 : value;
                case PERCENT_STORED -> experiment.method() == Method.CUBE || planar ? 50.0 : value;
                case STORED -> planar ? 1e7 : value;
                case FOREIGN_PHOTONS -> 0.0;
                case TREE_HEIGHT -> 1.0;
                case NODES_EXAMINED -> planar ? 1.0 : value;
                default -> value;
            };
        };
        List<Verdict> verdicts = judge(opposite, List.of(ThesisScene.values()));
        for (int number : new int[] {1, 2, 3, 4, 8, 9, 10, 13, 14}) {
            assertThat(verdict(verdicts, number).finding())
                    .as(verdict(verdicts, number).statement().claim())
                    .isEqualTo(Finding.CONTRADICTED);
        }
    }

    @Test
    void judge_givenTimes_comparesWithTwoAndSix() {
        assertThat(verdict(judge(times(2.2, 5.7), List.of(ThesisScene.COMPLEX)), 7)
                        .finding())
                .isEqualTo(Finding.CONFIRMED);
        assertThat(verdict(judge(times(2.2, 4.1), List.of(ThesisScene.COMPLEX)), 7)
                        .finding())
                .isEqualTo(Finding.CONTRADICTED);
    }

    @Test
    void flatness_givenPicture_countsNeighboursThatAreAlike() {
        LinearImage image = new LinearImage(5, 1);
        image.set(0, 0, 0.5, 0, 0);
        image.set(1, 0, 0.5, 0, 0);
        image.set(2, 0, 0.25, 0, 0);
        image.set(3, 0, 1, 0, 0);
        // Pairs of lit pixels that are not cut off: (0, 1) alike, (1, 2) not.
        assertThat(Pictures.flatness(image)).isEqualTo(0.5);
        assertThat(Pictures.brightest(image)).isEqualTo(1);
        assertThat(Pictures.flatness(new LinearImage(2, 2))).isZero();
    }

    private static BiFunction<Experiment, Quantity, Double> times(double monteCarlo, double adaptive) {
        return (experiment, quantity) -> {
            if (quantity != Quantity.PREPROCESSING_SECONDS) {
                return published().apply(experiment, quantity);
            }
            return switch (experiment.method()) {
                case MONTE_CARLO -> monteCarlo;
                case ADAPTIVE -> adaptive;
                default -> 1.0;
            };
        };
    }

    /** The thesis' numbers, and 1 for what it does not give. */
    private static BiFunction<Experiment, Quantity, Double> published() {
        return (experiment, quantity) -> PublishedTables.all().stream()
                .flatMap(table -> table.rows().stream()
                        .filter(row -> table.experiment(row).equals(experiment))
                        .flatMap(row -> table.published(row, quantity).stream()))
                .findFirst()
                .orElse(1.0);
    }

    private static List<Verdict> judge(BiFunction<Experiment, Quantity, Double> numbers, List<ThesisScene> scenes) {
        List<Outcome> outcomes = new ArrayList<>();
        for (PublishedTable table : PublishedTables.all()) {
            if (scenes.contains(table.scene()) && !table.isOfRetrieval()) {
                for (PublishedTable.Row row : table.rows()) {
                    Experiment experiment = table.experiment(row);
                    Map<Quantity, Statistic> counts = new EnumMap<>(Quantity.class);
                    for (Quantity quantity : Quantity.values()) {
                        counts.put(quantity, Statistic.of(numbers.apply(experiment, quantity)));
                    }
                    outcomes.add(new Outcome(experiment, counts, new LinearImage(2, 2)));
                }
            }
        }
        return Statements.judge(new Results(outcomes));
    }

    private static Verdict verdict(List<Verdict> verdicts, int number) {
        return verdicts.get(number - 1);
    }
}
