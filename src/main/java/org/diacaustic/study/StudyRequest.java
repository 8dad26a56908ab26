package org.diacaustic.study;

import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * What a study is to do.
 *
 * @param scene its name
 * @param command how to run it again
 * @param techniques to compare, each with every budget
 * @param budgets in any order; they are put from small to large
 * @param seeds pictures of a cheap point; of a dear one they are fewer
 * @param threads at least 1
 */
public record StudyRequest(
        String scene,
        String command,
        Machine machine,
        List<Technique> techniques,
        List<Budget> budgets,
        int seeds,
        int threads) {
    /** Rays before times. */
    private static final Comparator<Budget> FROM_SMALL_TO_LARGE = Comparator.<Budget>comparingInt(
                    budget -> budget instanceof Budget.Rays ? 0 : 1)
            .thenComparingDouble(Budget::amount);

    /** Seeds of a cheap point if nothing is said. */
    public static final int SEEDS = 20;

    /** Fewer say nothing about chance. */
    private static final int LEAST_SEEDS = 3;

    /** Light rays and eye rays of a picture up to which it is cheap. */
    private static final double CHEAP = 250_000;

    /** @throws IllegalArgumentException if there is nothing to compare, or something twice */
    public StudyRequest {
        techniques = List.copyOf(techniques);
        budgets = budgets.stream().sorted(FROM_SMALL_TO_LARGE).toList();
        requireDistinct(
                "techniques named", techniques.stream().map(Technique::name).toList());
        requireDistinct("budgets of", budgets.stream().map(Budget::label).toList());
        if (techniques.isEmpty() || budgets.isEmpty() || seeds < 1) {
            throw new IllegalArgumentException("a study needs techniques, budgets and seeds, but has "
                    + techniques.size() + ", " + budgets.size() + " and " + seeds);
        }
    }

    /** Points are kept by these names. */
    private static void requireDistinct(String what, List<String> names) {
        Set<String> seen = new HashSet<>();
        for (String name : names) {
            if (!seen.add(name)) {
                throw new IllegalArgumentException("there are two " + what + " '" + name + "'");
            }
        }
    }

    /**
     * How many seeds a point has: a number that does not depend on the machine, so that its errors don't.
     *
     * @param cost light rays and eye rays of one picture
     */
    int seedsFor(double cost) {
        int affordable = (int) Math.max(LEAST_SEEDS, seeds * CHEAP / cost);
        return Math.min(seeds, affordable);
    }
}
