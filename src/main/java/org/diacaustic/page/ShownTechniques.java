package org.diacaustic.page;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.diacaustic.study.Measure;
import org.diacaustic.study.TechniqueStudy;

/**
 * Which techniques are drawn together, and how. A chart of more than {@link #MOST} lines is unreadable: then the best of each
 * family stands for it, and each family has a chart of its own.
 */
final class ShownTechniques {
    static final int MOST = 9;

    private final StudyNumbers numbers;
    private final List<TechniqueStudy> shown;
    private final Map<String, Palette.Style> preProcessors = new LinkedHashMap<>();

    ShownTechniques(StudyNumbers numbers) {
        this.numbers = numbers;
        List<TechniqueStudy> all = numbers.started();
        shown = all.size() <= MOST
                ? all
                : numbers.families().values().stream()
                        .map(family -> numbers.best(family, Measure.PROCESSOR_SECONDS))
                        .limit(MOST)
                        .toList();
        for (TechniqueStudy study : all) {
            String name = study.technique().preProcessor();
            preProcessors.putIfAbsent(name, Palette.style(preProcessors.size()));
        }
    }

    /** Those of the chart that shows all there is. */
    List<TechniqueStudy> shown() {
        return shown;
    }

    /** The others. */
    List<TechniqueStudy> others() {
        List<TechniqueStudy> others = new ArrayList<>(numbers.started());
        others.removeAll(shown);
        return others;
    }

    /** Whether those shown stand for families. */
    boolean areRepresentatives() {
        return shown.size() < numbers.started().size();
    }

    /** How a shown technique is drawn, wherever all families are; the first style if it is not among them. */
    Palette.Style style(TechniqueStudy study) {
        return Palette.style(Math.max(0, shown.indexOf(study)));
    }

    /** How a technique is drawn among those of its family: the same for the same way to choose light rays. */
    Palette.Style styleWithinFamily(TechniqueStudy study) {
        return preProcessors.get(study.technique().preProcessor());
    }
}
