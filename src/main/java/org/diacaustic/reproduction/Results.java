package org.diacaustic.reproduction;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/** All outcomes of a run, to be asked by experiment. */
final class Results {
    private final Map<Experiment, Outcome> outcomes = new LinkedHashMap<>();

    Results(Collection<Outcome> all) {
        all.forEach(outcome -> outcomes.put(outcome.experiment(), outcome));
    }

    /** @throws IllegalStateException if the experiment was not run */
    Outcome get(ThesisScene scene, Method method, MapKind map) {
        Experiment experiment = new Experiment(scene, method, map);
        Outcome outcome = outcomes.get(experiment);
        if (outcome == null) {
            throw new IllegalStateException(experiment + " was not run");
        }
        return outcome;
    }

    Outcome get(Experiment experiment) {
        return get(experiment.scene(), experiment.method(), experiment.map());
    }

    List<Outcome> all() {
        return List.copyOf(outcomes.values());
    }

    /** The outcomes of pre-processing a scene into a kind of map, in the order of the thesis. */
    List<Outcome> of(ThesisScene scene, MapKind map) {
        return outcomes.values().stream()
                .filter(outcome -> outcome.experiment().scene() == scene
                        && outcome.experiment().map() == map)
                .toList();
    }

    Set<ThesisScene> scenes() {
        Set<ThesisScene> scenes = new TreeSet<>();
        outcomes.keySet().forEach(experiment -> scenes.add(experiment.scene()));
        return scenes;
    }
}
