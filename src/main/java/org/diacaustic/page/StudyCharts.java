package org.diacaustic.page;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.diacaustic.study.StudyReport;
import org.diacaustic.study.TechniqueStudy;

/** All charts of a study, for its page and as files of their own. */
final class StudyCharts {
    private final StudyNumbers numbers;
    private final ShownTechniques techniques;
    private final ErrorCharts errors;

    StudyCharts(StudyNumbers numbers, ShownTechniques techniques) {
        this.numbers = numbers;
        this.techniques = techniques;
        errors = new ErrorCharts(numbers, techniques);
    }

    /** SVG files by name; none if nothing was measured yet. */
    static Map<String, String> files(StudyReport report) {
        StudyNumbers numbers = new StudyNumbers(report);
        Map<String, String> files = new LinkedHashMap<>();
        if (!numbers.started().isEmpty()) {
            for (Chart chart : new StudyCharts(numbers, new ShownTechniques(numbers)).all()) {
                files.put(chart.name() + ".svg", chart.wide().file());
            }
        }
        return files;
    }

    private List<Chart> all() {
        List<Chart> all = new ArrayList<>();
        for (PlotAxis axis : PlotAxis.values()) {
            all.add(error(axis));
        }
        all.addAll(families());
        all.addAll(chance(numbers.started()));
        all.add(brightness());
        all.add(times());
        return all;
    }

    Chart error(PlotAxis axis) {
        return errors.all(axis);
    }

    /** None if all techniques are in one chart. */
    List<Chart> families() {
        return techniques.areRepresentatives() ? errors.families() : List.of();
    }

    List<Chart> chance(List<TechniqueStudy> studies) {
        ChanceCharts charts = new ChanceCharts(numbers);
        return studies.stream().map(charts::of).toList();
    }

    Chart brightness() {
        return BrightnessPlot.chart(Brightness.all(numbers));
    }

    Chart times() {
        return TimeBars.chart(numbers);
    }
}
