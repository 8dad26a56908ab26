package org.diacaustic.reproduction;

import java.util.ArrayList;
import java.util.List;

/** A table of the thesis with our numbers beside its own. */
record Comparison(PublishedTable table, List<Row> rows) {

    /** One technique; a cell for each column of {@link #columns}. */
    record Row(PublishedTable.Row published, List<Cell> cells) {}

    static Comparison of(PublishedTable table, Results results) {
        List<Quantity> columns = columns(table);
        List<Row> rows = table.rows().stream()
                .map(row -> new Row(
                        row,
                        columns.stream()
                                .map(column -> cell(table, row, column, results))
                                .toList()))
                .toList();
        return new Comparison(table, rows);
    }

    private static Cell cell(PublishedTable table, PublishedTable.Row row, Quantity column, Results results) {
        Statistic ours = results.get(table.experiment(row)).statistic(column);
        return new Cell(column, table.published(row, column), ours, table.remark(row, column));
    }

    List<Quantity> columns() {
        return columns(table);
    }

    private static List<Quantity> columns(PublishedTable table) {
        List<Quantity> all = new ArrayList<>(table.columns());
        all.addAll(table.own());
        return all;
    }
}
