package org.diacaustic.reproduction;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** The published numbers agree with each other wherever the thesis' own rules say so: a wrong digit would show. */
class PublishedTablesTest {

    @Test
    void all_givenTheThesis_hasItsTablesAndFigures() {
        assertThat(PublishedTables.all())
                .extracting(PublishedTable::number)
                .containsExactly(3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14);
        List<Integer> figures = PublishedTables.all().stream()
                .flatMap(table -> table.rows().stream())
                .map(PublishedTable.Row::figure)
                .filter(figure -> figure > 0)
                .sorted()
                .toList();
        assertThat(figures).isEqualTo(IntStream.rangeClosed(7, 33).boxed().toList());
    }

    @Test
    void rows_givenPercentages_areThoseOfTheirCounts() {
        int rows = 0;
        for (PublishedTable table : PublishedTables.all()) {
            if (!table.columns().contains(Quantity.PERCENT_STORED)) {
                continue;
            }
            for (PublishedTable.Row row : table.rows()) {
                double rays = value(table, row, Quantity.RAYS_TRACED);
                // The thesis cuts or rounds to two decimals.
                assertThat(value(table, row, Quantity.PERCENT_INTERSECTING))
                        .isCloseTo(100 * value(table, row, Quantity.OBJECT_INTERSECTIONS) / rays, within(0.0101));
                assertThat(value(table, row, Quantity.PERCENT_STORED))
                        .isCloseTo(100 * value(table, row, Quantity.STORED) / rays, within(0.0101));
                if (table.scene() != ThesisScene.COMPLEX) {
                    assertThat(value(table, row, Quantity.LIGHT_TESTS)).isEqualTo(3 * rays);
                } else {
                    // 16 tests for a ray that comes near nothing, and 6 for every volume of the fractal that it opens.
                    assertThat((value(table, row, Quantity.LIGHT_TESTS) - 16 * rays) % 6)
                            .isZero();
                }
                rows++;
            }
        }
        assertThat(rows).isEqualTo(22);
    }

    @Test
    void rows_givenTablesOfRetrieval_areThoseOfThePhotonMapsBeforeThem() {
        for (PublishedTable table : PublishedTables.all()) {
            if (table.isOfRetrieval()) {
                List<Experiment> before = PublishedTables.all().stream()
                        .filter(other -> other.number() == table.number() - 1)
                        .flatMap(other -> other.rows().stream().map(other::experiment))
                        .toList();
                assertThat(table.rows().stream().map(table::experiment)).isEqualTo(before);
            }
        }
    }

    @Test
    void of_givenOneScene_hasItsTablesOnly() {
        assertThat(PublishedTables.of(Set.of(ThesisScene.REFRACTION)))
                .extracting(PublishedTable::number)
                .containsExactly(7, 8, 9, 10);
    }

    @Test
    void remark_givenRowsOutOfReach_isThereForThemOnly() {
        PublishedTable table = PublishedTables.all().get(4);
        assertThat(table.number()).isEqualTo(7);
        PublishedTable.Row row = table.rows().get(0);
        assertThat(table.remark(row, Quantity.REFLECTION_RAYS)).isPresent();
        assertThat(table.remark(row, Quantity.REFRACTION_RAYS)).isEmpty();
    }

    private static double value(PublishedTable table, PublishedTable.Row row, Quantity quantity) {
        return table.published(row, quantity).orElseThrow();
    }
}
