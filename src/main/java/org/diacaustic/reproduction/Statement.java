package org.diacaustic.reproduction;

import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * Something the thesis says that a run can test.
 *
 * @param section where it says so
 * @param scenes that must have been rendered
 * @param test decides from the numbers of a run
 */
record Statement(int number, String claim, String section, Set<ThesisScene> scenes, Function<Results, Answer> test) {

    /** Whether the numbers bear the claim out, and those numbers. */
    record Answer(boolean holds, String evidence) {}

    Verdict judge(Results results) {
        if (!results.scenes().containsAll(scenes)) {
            String missing = scenes.stream()
                    .filter(scene -> !results.scenes().contains(scene))
                    .map(ThesisScene::key)
                    .sorted()
                    .collect(Collectors.joining(" and "));
            return new Verdict(this, Finding.NOT_TESTED, "needs the scene " + missing);
        }
        Answer answer = test.apply(results);
        return new Verdict(this, answer.holds() ? Finding.CONFIRMED : Finding.CONTRADICTED, answer.evidence());
    }
}
