package org.diacaustic.trial;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.diacaustic.parallel.Workers;
import org.diacaustic.stability.CaseFile;
import org.diacaustic.stability.CaseResult;
import org.diacaustic.stability.Launcher;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;
import org.diacaustic.stability.StabilityRun;
import org.diacaustic.stability.Values;
import org.diacaustic.stability.Verdict;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Whether the trials of photons would tell if the answer were another. */
class PhotonTrialsTest {
    private final Operations operations = Trials.all(new Launcher(Path.of("java"), List.of(), Optional.empty()));

    @ParameterizedTest
    @CsvSource({
        "P-KDTREE-04, returned, 3",
        "P-KDTREE-04, kth_distance_sq, 0.2188164",
        "P-KDTREE-04, sum_of_k_distances_sq, 0.3164290",
        "P-KDTREE-04, count_in_radius_closed, 1",
        "P-KDTREE-07, max_tree_depth, 5",
        "P-KDTREE-09, count_in_radius_closed, 500",
        "P-DENSITY-02, E_ratio_k_over_area, 1",
        "P-DENSITY-02, E_ratio_(k-1)_over_area, 1.02",
        "P-DENSITY-02, rel_sd_of_(k-1)_form, 0.1552",
        "P-DENSITY-03, E_ratio, 0.53116",
        "P-DENSITY-03, alpha_that_is_unbiased, 1.7283",
        "P-DENSITY-04, E_ratio_fixed_radius, 0.999999",
        "P-DENSITY-04, norm, 0.3333",
        "P-DENSITY-05, E_ratio_unclipped, 0.53",
        "P-DENSITY-06, corner_of_square_ratio_at_corner, 0.27",
        "P-DENSITY-07, with_normal_filter, 0.72",
        "P-DENSITY-07, without_normal_filter_ball, 1.1",
        "P-DENSITY-08, dark_side_with_normal_filter, 0.1",
        "P-DENSITY-08, dark_side_without_filter, 0.9",
        "P-DENSITY-09, cap_area, 0.7854",
        "P-DENSITY-09, E_ratio, 1.1",
        "P-DENSITY-10, estimate_over_pointwise, 1.01",
        "P-DENSITY-11, estimate_over_pointwise, 0.8125",
        "P-DENSITY-12, N_when_ratio_is_1e-6, 1.35926552e36",
        "P-STAT-01, mean, 50000",
        "P-STAT-03, midpoint_solid_angle_sum_minus_4pi, 0.00075177",
        "P-STAT-03, unweighted_axis_gain, 0.5236",
        "P-STAT-04, duplicate_photon_positions, 1",
        "P-STAT-06, z, 9"
    })
    void run_givenAWrongAnswer_fails(String id, String name, String wrong) {
        NumericCase asked = find(id);
        Map<String, Object> expected = new HashMap<>();
        for (String key : asked.expected().keys()) {
            expected.put(
                    key,
                    key.equals("ratio")
                            ? asked.expected().list(key)
                            : asked.expected().text(key));
        }
        expected.put(name, wrong);
        assertThat(run(with(asked, asked.inputs(), Values.of("expected", expected))))
                .isEqualTo(Verdict.FAIL);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "P-KDTREE-01", "P-KDTREE-04", "P-KDTREE-07", "P-KDTREE-13", "P-KDTREE-14", "P-KDTREE-15",
                        "P-DENSITY-01",
                "P-DENSITY-02", "P-DENSITY-03", "P-DENSITY-04", "P-DENSITY-06", "P-DENSITY-07", "P-DENSITY-08",
                        "P-DENSITY-09",
                "P-DENSITY-11", "P-DENSITY-12", "P-STAT-03", "P-STAT-04"
            })
    void run_givenTheRightAnswer_passes(String id) {
        assertThat(run(find(id))).isIn(Verdict.PASS, Verdict.STRETCH);
    }

    @ParameterizedTest
    @CsvSource({
        "P-KDTREE-04, mode, spiral",
        "P-KDTREE-13, bad, good power",
        "P-KDTREE-13, bad, heavy photon",
        "P-DENSITY-01, k, 1",
        "P-DENSITY-03, kernel, unheard-of",
        "P-DENSITY-08, gap, 2",
        "P-STAT-01, h, 0",
        "P-STAT-02, lights, laser",
    })
    void run_givenWhatIsNotKnown_doesNotApply(String id, String name, String unknown) {
        NumericCase asked = find(id);
        Map<String, Object> inputs = new HashMap<>();
        for (String key : asked.inputs().keys()) {
            inputs.put(key, asked.inputs().text(key));
        }
        inputs.put(name, name.equals("lights") ? List.of(unknown) : unknown);
        if (asked.inputs().has("query")) {
            inputs.put("query", asked.inputs().list("query"));
        }
        assertThat(run(with(asked, Values.of("inputs", inputs), asked.expected())))
                .isEqualTo(Verdict.NOT_APPLICABLE);
    }

    private static NumericCase find(String id) {
        return CaseFile.bundled().stream()
                .filter(one -> one.id().equals(id))
                .findFirst()
                .orElseThrow();
    }

    private static NumericCase with(NumericCase asked, Values inputs, Values expected) {
        return new NumericCase(
                asked.id(),
                asked.category(),
                asked.title(),
                asked.operation(),
                inputs,
                expected,
                asked.tolerance(),
                asked.acceptable(),
                asked.typicalFailure());
    }

    private Verdict run(NumericCase asked) {
        return new StabilityRun(operations, Set.of())
                .run(List.of(asked), new Workers(1), (CaseResult result) -> {})
                .results()
                .get(0)
                .verdict();
    }
}
