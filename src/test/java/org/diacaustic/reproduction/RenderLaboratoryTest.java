package org.diacaustic.reproduction;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Renders for real; the numbers that lattices fix come out to the digit. */
class RenderLaboratoryTest {
    private final RenderLaboratory laboratory = new RenderLaboratory();

    @Test
    void measure_givenPlanarLattice_countsAsTheThesis() {
        Experiment global = new Experiment(ThesisScene.CONTROL, Method.PLANAR, MapKind.PHOTON_MAP);
        Map<Quantity, Double> counts = laboratory.measure(global, 1, false).counts();
        // Table 5; a diamond of |x| + |z| < 105.25 steps holds 2·105·106 points of a lattice that misses its middle.
        assertThat(counts.get(Quantity.STORED)).isEqualTo(22_260);
        assertThat(counts.get(Quantity.RAYS_TRACED)).isEqualTo(199_501);
        assertThat(counts.get(Quantity.LIGHT_TESTS)).isEqualTo(598_503);
        assertThat(counts.get(Quantity.LOOKUPS)).isEqualTo(21_433);
        // 64,197 in Table 6: the radius was chosen for it.
        assertThat(counts.get(Quantity.PHOTONS_USED)).isBetween(64_000.0, 64_400.0);
        assertThat(counts.get(Quantity.BALANCED_NODES)).isLessThan(counts.get(Quantity.NODES_EXAMINED) / 5);

        Experiment individual = new Experiment(ThesisScene.CONTROL, Method.PLANAR, MapKind.AMBIENT_MAPS);
        Measurement maps = laboratory.measure(individual, 1, true);
        assertThat(maps.counts().get(Quantity.STORED)).isEqualTo(17_290);
        assertThat(maps.counts().get(Quantity.RAYS_TRACED)).isEqualTo(194_531);
        assertThat(maps.picture()).isPresent();
    }

    @Test
    void measure_givenSeeds_repeatsThemAndDiffersBetweenThem() {
        Experiment random = new Experiment(ThesisScene.REFRACTION, Method.MONTE_CARLO, MapKind.AMBIENT_MAPS);
        List<Optional<Double>> stored = List.of(1L, 1L, 2L).stream()
                .map(seed -> Optional.of(
                        laboratory.measure(random, seed, false).counts().get(Quantity.STORED)))
                .toList();
        assertThat(stored.get(0)).isEqualTo(stored.get(1)).isNotEqualTo(stored.get(2));
    }

    /** Techniques whose rules were fitted: the largest distances from the thesis, in percent, half as much again as measured. */
    @ParameterizedTest
    @CsvSource({
        "CONTROL, ADAPTIVE, PHOTON_MAP, 6",
        "REFRACTION, ADAPTIVE, AMBIENT_MAPS, 4.1",
        "COMPLEX, PLANAR, PHOTON_MAP, 1.9",
        "COMPLEX, PLANAR, AMBIENT_MAPS, 1.9",
    })
    void measure_givenFittedTechnique_staysNearTheThesis(
            ThesisScene scene, Method method, MapKind map, double percent) {
        Experiment experiment = new Experiment(scene, method, map);
        Map<Quantity, Double> counts = laboratory.measure(experiment, 1, false).counts();
        for (Quantity quantity :
                List.of(Quantity.LIGHT_TESTS, Quantity.OBJECT_INTERSECTIONS, Quantity.STORED, Quantity.RAYS_TRACED)) {
            assertThat(counts.get(quantity))
                    .as("%s", quantity)
                    .isCloseTo(PublishedTables.number(experiment, quantity), withinPercentage(percent));
        }
    }
}
