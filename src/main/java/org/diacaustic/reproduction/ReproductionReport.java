package org.diacaustic.reproduction;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * What a {@link Reproduction} found: the thesis' tables with ours beside them, its figures, what must hold exactly, and a
 * verdict on what it concludes. All of it is computed from the run.
 */
public final class ReproductionReport {
    private final long firstSeed;
    private final int seeds;
    private final int threads;
    private final double seconds;
    private final Results results;
    private final List<ThesisScene> scenes;
    private final List<Comparison> comparisons;
    private final List<Figure> figures;
    private final List<Identity> identities;
    private final List<Verdict> verdicts;

    ReproductionReport(Results results, long firstSeed, int seeds, int threads, double seconds) {
        this.firstSeed = firstSeed;
        this.seeds = seeds;
        this.threads = threads;
        this.seconds = seconds;
        this.results = results;
        this.scenes = List.copyOf(results.scenes());
        this.comparisons = PublishedTables.of(results.scenes()).stream()
                .map(table -> Comparison.of(table, results))
                .toList();
        this.figures = figures(results);
        this.identities = Identities.check(results);
        this.verdicts = Statements.judge(results);
    }

    private List<Figure> figures(Results results) {
        Pictures pictures = new Pictures(results);
        List<Figure> all = new ArrayList<>();
        for (ThesisScene scene : scenes) {
            CostChart chart = CostChart.of(scene, comparisons);
            all.add(new Figure(scene.costChart(), scene, chart.title(), chart.image(), Optional.of(chart.svg())));
        }
        for (Comparison comparison : comparisons) {
            for (PublishedTable.Row row : comparison.table().rows()) {
                Outcome outcome = results.get(comparison.table().experiment(row));
                if (row.figure() > 0) {
                    all.add(new Figure(
                            row.figure(),
                            outcome.experiment().scene(),
                            caption(row.figure(), outcome, pictures),
                            outcome.picture(),
                            Optional.empty()));
                }
            }
        }
        all.sort(Comparator.comparingInt(Figure::number));
        return List.copyOf(all);
    }

    /** In the control scene it is known how the picture should be, so there the error is told. */
    private static String caption(int number, Outcome outcome, Pictures pictures) {
        Experiment experiment = outcome.experiment();
        String caption = "Figure " + number + ": " + experiment.title();
        if (experiment.scene() != ThesisScene.CONTROL || experiment.method() == Method.NON_REFRACTIVE) {
            return caption;
        }
        return caption + String.format(Locale.ROOT, "; error %.1f %%", 100 * pictures.error(outcome));
    }

    long firstSeed() {
        return firstSeed;
    }

    /** How many seeds random techniques ran with. */
    int seeds() {
        return seeds;
    }

    int threads() {
        return threads;
    }

    /** Wall clock of all renders. */
    double seconds() {
        return seconds;
    }

    Results results() {
        return results;
    }

    List<ThesisScene> scenes() {
        return scenes;
    }

    List<Comparison> comparisons() {
        return comparisons;
    }

    /** In the order of their numbers. */
    List<Figure> figures() {
        return figures;
    }

    List<Identity> identities() {
        return identities;
    }

    List<Verdict> verdicts() {
        return verdicts;
    }

    /** In one line: how much came out as it should. */
    public String summary() {
        long exact = identities.stream().filter(Identity::holds).count();
        long confirmed =
                verdicts.stream().filter(v -> v.finding() == Finding.CONFIRMED).count();
        long contradicted = verdicts.stream()
                .filter(v -> v.finding() == Finding.CONTRADICTED)
                .count();
        return String.format(
                Locale.ROOT,
                "%d of %d identities hold; of %d statements %d are confirmed, %d contradicted; %.0f s",
                exact,
                identities.size(),
                verdicts.size(),
                confirmed,
                contradicted,
                seconds);
    }

    /**
     * Writes the page, the data, the pictures and the scenes into a folder, which is made if it is not there. Files of these
     * names are written over; others are left alone.
     *
     * @return the page
     */
    public Path write(Path folder) throws IOException {
        return new ReproductionFiles(this, folder).write();
    }
}
