package org.diacaustic.reproduction;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A table as the thesis prints it.
 *
 * @param number of the table in the thesis
 * @param columns what its columns count
 * @param own columns that only we have, set beside the thesis' own because they explain them
 * @param remarks on single numbers that no reproduction can be expected to meet, and why
 */
record PublishedTable(
        int number,
        ThesisScene scene,
        String title,
        List<Quantity> columns,
        List<Quantity> own,
        List<Row> rows,
        List<Remark> remarks) {

    PublishedTable {
        columns = List.copyOf(columns);
        own = List.copyOf(own);
        rows = List.copyOf(rows);
        remarks = List.copyOf(remarks);
        for (Row row : rows) {
            if (row.values().size() != columns.size()) {
                throw new IllegalArgumentException(
                        "Table " + number + ": " + row.method() + " has not a number for every column");
            }
        }
    }

    /** The same with remarks. */
    PublishedTable with(Remark... more) {
        return new PublishedTable(number, scene, title, columns, own, rows, Arrays.asList(more));
    }

    Experiment experiment(Row row) {
        return new Experiment(scene, row.method(), row.map());
    }

    /** Whether it counts how maps are read, which is done in the runs of the table of pre-processing. */
    boolean isOfRetrieval() {
        return columns.contains(Quantity.NODES_EXAMINED);
    }

    /** What the thesis prints; nothing in columns of our own. */
    Optional<Double> published(Row row, Quantity column) {
        int place = columns.indexOf(column);
        return place < 0 ? Optional.empty() : Optional.of(row.values().get(place));
    }

    Optional<Remark> remark(Row row, Quantity column) {
        return remarks.stream()
                .filter(remark ->
                        remark.columns().getOrDefault(row.method(), List.of()).contains(column))
                .findFirst();
    }

    /**
     * One technique's numbers.
     *
     * @param figure its picture in the thesis; 0 if it is not shown, or shown with another table
     */
    record Row(Method method, MapKind map, int figure, List<Double> values) {}

    /** Why some numbers are out of reach. */
    record Remark(String reason, Map<Method, List<Quantity>> columns) {}
}
