package org.diacaustic.page;

import java.util.List;

/** Knows where a chart is empty. */
final class FreeSpace {
    /** Of each piece of a line, so many points are looked at. */
    private static final int POINTS = 24;

    private final PlotArea area;
    private final List<PlotLine> lines;
    private final List<Double> levels;

    /** @param levels where horizontal lines lie, on the drawing */
    FreeSpace(PlotArea area, List<PlotLine> lines, List<Double> levels) {
        this.area = area;
        this.lines = List.copyOf(lines);
        this.levels = List.copyOf(levels);
    }

    /** A rectangle of the drawing. */
    record Box(double left, double top, double width, double height) {
        boolean contains(double x, double y) {
            return x > left && x < left + width && y > top && y < top + height;
        }
    }

    /** The box in which least is drawn; the first of those that are equal. */
    Box emptiest(List<Box> boxes) {
        Box best = boxes.get(0);
        long least = Long.MAX_VALUE;
        for (Box box : boxes) {
            long within = count(box);
            if (within < least) {
                least = within;
                best = box;
            }
        }
        return best;
    }

    private long count(Box box) {
        long count = levels.stream()
                .filter(level -> level > box.top && level < box.top + box.height)
                .count();
        for (PlotLine line : lines) {
            PlotLine.Dot before = line.dots().get(0);
            for (PlotLine.Dot dot : line.dots()) {
                count += count(box, before, dot);
                before = dot;
            }
        }
        return count;
    }

    private long count(Box box, PlotLine.Dot from, PlotLine.Dot to) {
        long count = 0;
        for (int i = 0; i < POINTS; i++) {
            double part = (double) i / (POINTS - 1);
            double x = area.x().place(from.x()) * (1 - part) + area.x().place(to.x()) * part;
            double y = area.y().place(from.y()) * (1 - part) + area.y().place(to.y()) * part;
            count += box.contains(x, y) ? 1 : 0;
        }
        return count;
    }
}
