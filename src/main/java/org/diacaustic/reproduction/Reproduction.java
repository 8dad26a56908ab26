package org.diacaustic.reproduction;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.parallel.Workers;
import org.diacaustic.render.ProgressListener;

/**
 * Does the thesis' experiments again: every technique on its scenes, random ones with many seeds. {@link #run} takes
 * minutes; what it returns can be written as a page, as data and as pictures.
 */
public final class Reproduction {
    /** Seeds of random techniques, unless it is to be quick. */
    public static final int SEEDS = 20;

    /** Seeds if it is to be quick: the fewest that have a spread one can speak of. */
    public static final int QUICK_SEEDS = 3;

    private final Set<ThesisScene> scenes;
    private final long firstSeed;
    private final int seeds;
    private final Laboratory laboratory;
    private final StopSignal stop = new StopSignal();

    /**
     * @param scenes those to render
     * @param firstSeed random techniques run with this seed and those after it
     * @param seeds how many
     */
    public Reproduction(Set<ThesisScene> scenes, long firstSeed, int seeds) {
        this(scenes, firstSeed, seeds, new RenderLaboratory());
    }

    Reproduction(Set<ThesisScene> scenes, long firstSeed, int seeds, Laboratory laboratory) {
        if (seeds < 1 || scenes.isEmpty()) {
            throw new IllegalArgumentException("needs at least one scene and one seed, but has " + scenes.size()
                    + " scenes and " + seeds + " seeds");
        }
        this.scenes = EnumSet.copyOf(scenes);
        this.firstSeed = firstSeed;
        this.seeds = seeds;
        this.laboratory = laboratory;
    }

    /** Stops soon, from any thread; {@link #run} then fails. */
    public void cancel() {
        stop.set();
    }

    /**
     * Runs all experiments. Apart from times, the results depend on the seed only.
     *
     * @param listener hears of every finished run
     * @throws IllegalStateException if it was cancelled
     */
    public ReproductionReport run(int threads, ProgressListener listener) {
        long start = System.nanoTime();
        List<Run> runs = runs();
        Measurement[] measurements = new Measurement[runs.size()];
        int[] done = {0};
        new Workers(threads, stop).run(runs.size(), () -> number -> {
            Run run = runs.get(number);
            measurements[number] =
                    laboratory.measure(run.experiment(), firstSeed + run.repetition(), run.repetition() == 0);
            synchronized (done) {
                listener.progressed(++done[0], runs.size());
            }
        });
        if (stop.isSet()) {
            throw new IllegalStateException("the reproduction was cancelled");
        }
        double seconds = (System.nanoTime() - start) * 1e-9;
        return new ReproductionReport(new Results(outcomes(runs, measurements)), firstSeed, seeds, threads, seconds);
    }

    /** One experiment with one seed. */
    private record Run(Experiment experiment, int repetition) {}

    /** All that is to be done; an experiment's runs follow each other. */
    private List<Run> runs() {
        List<Run> runs = new ArrayList<>();
        for (PublishedTable table : PublishedTables.of(scenes)) {
            for (PublishedTable.Row row : table.rows()) {
                int repetitions = row.method().isRandom() ? seeds : 1;
                for (int i = 0; i < (table.isOfRetrieval() ? 0 : repetitions); i++) {
                    runs.add(new Run(table.experiment(row), i));
                }
            }
        }
        return runs;
    }

    private static List<Outcome> outcomes(List<Run> runs, Measurement[] measurements) {
        List<Outcome> outcomes = new ArrayList<>();
        for (int first = 0; first < runs.size(); ) {
            Experiment experiment = runs.get(first).experiment();
            List<Measurement> own = new ArrayList<>();
            int next = first;
            while (next < runs.size() && runs.get(next).experiment().equals(experiment)) {
                own.add(measurements[next++]);
            }
            outcomes.add(Outcome.of(experiment, own));
            first = next;
        }
        return outcomes;
    }
}
