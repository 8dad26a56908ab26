package org.diacaustic.reproduction;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.diacaustic.chart.Canvas;
import org.diacaustic.chart.Ink;
import org.diacaustic.chart.PixelCanvas;
import org.diacaustic.chart.SvgCanvas;
import org.diacaustic.image.LinearImage;

/**
 * What pre-processing costs, in intersection tests: a bar for each technique and map, the thesis' as an outline, ours full
 * [Thesis Figures 4 - 6]. The axis is logarithmic, so only the ends of bars mean something, and each has its number.
 */
final class CostChart {
    private static final int WIDTH = 640;
    private static final int TOP = 64;
    private static final int LEFT = 8;
    private static final int AXIS_LENGTH = 520;
    private static final int BAR = 12;
    private static final int HEADING = 18;
    private static final int BOTTOM = 12;
    private static final int FIRST_DECADE = 5;
    private static final int LAST_DECADE = 8;

    private final String title;
    private final List<Group> groups;

    private CostChart(String title, List<Group> groups) {
        this.title = title;
        this.groups = groups;
    }

    /** The bars of one technique. */
    private record Group(String title, List<Bar> bars) {
        int height() {
            return HEADING + bars.size() * BAR;
        }
    }

    private record Bar(double value, MapKind map, boolean published) {
        Ink ink() {
            return map == MapKind.AMBIENT_MAPS ? Ink.INDIVIDUAL : Ink.GLOBAL;
        }

        String label() {
            return String.format(Locale.ROOT, published ? "%,.0f thesis" : "%,.0f ours", value);
        }
    }

    /** @param comparisons all tables of the scene */
    static CostChart of(ThesisScene scene, List<Comparison> comparisons) {
        List<Group> groups = new ArrayList<>();
        for (Method method : Method.values()) {
            List<Bar> bars = new ArrayList<>();
            for (Comparison comparison : comparisons) {
                for (Comparison.Row row : comparison.rows()) {
                    boolean belongs = comparison.table().scene() == scene
                            && row.published().method() == method;
                    row.cells().stream()
                            .filter(cell -> belongs && cell.quantity() == Quantity.LIGHT_TESTS)
                            .forEach(cell -> addBars(cell, row.published().map(), bars));
                }
            }
            if (!bars.isEmpty()) {
                groups.add(new Group(method.title(), bars));
            }
        }
        String title = "Figure " + scene.costChart() + ": cost of pre-processing the " + scene.key() + " scene";
        return new CostChart(title, groups);
    }

    private static void addBars(Cell cell, MapKind map, List<Bar> bars) {
        bars.add(new Bar(cell.published().orElseThrow(), map, true));
        bars.add(new Bar(cell.ours().mean(), map, false));
    }

    String title() {
        return title;
    }

    LinearImage image() {
        PixelCanvas canvas = new PixelCanvas(WIDTH, height());
        draw(canvas);
        return canvas.image();
    }

    String svg() {
        SvgCanvas canvas = new SvgCanvas(WIDTH, height(), title);
        draw(canvas);
        return canvas.toString();
    }

    private int height() {
        return TOP + groups.stream().mapToInt(Group::height).sum() + BOTTOM;
    }

    private void draw(Canvas canvas) {
        canvas.text(LEFT, 16, title);
        canvas.fill(LEFT, 24, BAR - 3, BAR - 3, Ink.INDIVIDUAL);
        canvas.text(LEFT + 14, 32, "individual maps");
        canvas.fill(LEFT + 130, 24, BAR - 3, BAR - 3, Ink.GLOBAL);
        canvas.text(LEFT + 144, 32, "global map");
        canvas.text(LEFT + 240, 32, "intersection tests, logarithmic");
        for (int decade = FIRST_DECADE; decade <= LAST_DECADE; decade++) {
            double x = x(Math.pow(10, decade));
            canvas.fill(x, TOP - 8, 1, height() - TOP, Ink.GRID);
            String label = String.format(Locale.ROOT, "%,.0f", Math.pow(10, decade));
            if (decade == FIRST_DECADE) {
                canvas.text(x, TOP - 12, label);
            } else {
                canvas.textAround(x, TOP - 12, label);
            }
        }
        double y = TOP;
        for (Group group : groups) {
            canvas.text(LEFT, y + HEADING - 5, group.title());
            y += HEADING;
            for (Bar bar : group.bars()) {
                draw(bar, y, canvas);
                y += BAR;
            }
        }
    }

    private static void draw(Bar bar, double y, Canvas canvas) {
        double length = x(bar.value()) - LEFT;
        if (bar.published()) {
            canvas.outline(LEFT, y, length, BAR - 2, bar.ink());
        } else {
            canvas.fill(LEFT, y, length, BAR - 2, bar.ink());
        }
        canvas.text(LEFT + length + 5, y + BAR - 3, bar.label());
    }

    private static double x(double value) {
        double decades = Math.log10(value) - FIRST_DECADE;
        return LEFT + AXIS_LENGTH * Math.max(0, decades) / (LAST_DECADE - FIRST_DECADE);
    }
}
