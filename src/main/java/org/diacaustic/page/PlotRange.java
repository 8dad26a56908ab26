package org.diacaustic.page;

import java.util.List;
import java.util.stream.DoubleStream;

/** From where to where an axis runs; both positive. */
record PlotRange(double least, double largest) {
    /** Left free at both ends. */
    private static final double MARGIN = 0.06;

    private static PlotRange around(DoubleStream values) {
        var summary = values.summaryStatistics();
        if (summary.getCount() == 0) {
            return new PlotRange(0.1, 1);
        }
        double margin = Math.max(Math.pow(summary.getMax() / summary.getMin(), MARGIN), 1.15);
        return new PlotRange(summary.getMin() / margin, summary.getMax() * margin);
    }

    static PlotRange ofX(List<PlotLine> lines) {
        return around(lines.stream().flatMap(line -> line.dots().stream()).mapToDouble(PlotLine.Dot::x));
    }

    /** @param more that is to be seen too */
    static PlotRange ofY(List<PlotLine> lines, double... more) {
        DoubleStream dots = lines.stream().flatMap(line -> line.dots().stream()).flatMapToDouble(PlotRange::heights);
        return around(DoubleStream.concat(dots, DoubleStream.of(more).filter(value -> value > 0)));
    }

    private static DoubleStream heights(PlotLine.Dot dot) {
        return dot.hasBand()
                ? DoubleStream.of(dot.y(), dot.band().low(), dot.band().high())
                : DoubleStream.of(dot.y());
    }
}
