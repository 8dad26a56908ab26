package org.diacaustic.page;

import java.util.List;
import org.diacaustic.chart.Lettering;
import org.diacaustic.chart.Lettering.Anchor;
import org.diacaustic.chart.SvgCanvas;
import org.diacaustic.study.Measure;
import org.diacaustic.study.StudyPoint;
import org.diacaustic.study.TechniqueStudy;

/**
 * Where the time of a picture goes: a bar a technique, of parts. All bars are equally long, since some techniques take a thousand
 * times as long as others; how long is written beside.
 */
final class TimeBars {
    private static final double LETTER = 12.5;
    private static final double ROW = 24;
    private static final double TOP = 40;

    private static final List<Part> PARTS = List.of(
            new Part(Measure.FORWARD_SECONDS, Palette.LINES.get(0)),
            new Part(Measure.BUILD_SECONDS, Palette.LINES.get(2)),
            new Part(Measure.GATHER_SECONDS, Palette.LINES.get(4)),
            new Part(Measure.EYE_SECONDS, Palette.LINES.get(3)));

    private final StudyNumbers numbers;
    private final List<TechniqueStudy> rows;
    private final int width;
    private final double left;

    private record Part(Measure measure, String color) {}

    private TimeBars(StudyNumbers numbers, int width) {
        this.numbers = numbers;
        this.rows = numbers.started();
        this.width = width;
        Lettering names = Lettering.of(LETTER, Palette.TEXT);
        left = 12
                + rows.stream()
                        .mapToDouble(row -> names.width(row.technique().name()))
                        .max()
                        .orElse(0);
    }

    static Chart chart(StudyNumbers numbers) {
        return new Chart(
                "time-parts",
                "parts of the time by the clock, with the largest budget of each technique",
                new TimeBars(numbers, 860).draw(),
                new TimeBars(numbers, 400).draw());
    }

    private SvgCanvas draw() {
        boolean isNarrow = width < 600;
        double top = isNarrow ? TOP + 20 : TOP;
        int height = (int) (top + rows.size() * ROW + 6);
        SvgCanvas canvas = new SvgCanvas(width, height, "where the time of a picture goes");
        canvas.fill(0, 0, width, height, Palette.PAPER);
        double place = isNarrow ? 8 : left;
        Lettering letters = Lettering.of(LETTER, Palette.TEXT);
        for (int i = 0; i < PARTS.size(); i++) {
            Part part = PARTS.get(i);
            int rowOfPart = i / 2;
            double line = isNarrow ? 6 + 20.0 * rowOfPart : 10;
            canvas.fill(place, line, 12, 12, part.color);
            canvas.text(place + 17, line + 10.5, part.measure.title(), letters);
            double next = place + 34 + letters.width(part.measure.title());
            place = !isNarrow ? next : i % 2 == 0 ? width / 2.0 : 8;
        }
        for (int i = 0; i < rows.size(); i++) {
            row(canvas, rows.get(i), top + i * ROW);
        }
        return canvas;
    }

    private void row(SvgCanvas canvas, TechniqueStudy row, double top) {
        StudyPoint point = StudyNumbers.last(row);
        double foot = top + ROW / 2 + 0.35 * LETTER;
        Lettering letters = Lettering.of(LETTER, Palette.TEXT);
        canvas.text(left - 10, foot, row.technique().name(), letters.at(Anchor.END));
        double all = point.mean(Measure.WALL_SECONDS);
        double end = width - 74;
        double x = left;
        canvas.fill(left, top + 4, end - left, ROW - 8, Palette.BEHIND);
        for (Part part : PARTS) {
            double share = point.mean(part.measure) / all;
            if (share > 0) {
                double length = Math.min(share * (end - left), end - x);
                canvas.beginGroup("dot", words(row, part, point));
                canvas.fill(x, top + 4, length, ROW - 8, part.color);
                canvas.endGroup();
                x += length;
            }
        }
        canvas.text(end + 6, foot, Numbers.seconds(all), letters);
    }

    private static String words(TechniqueStudy row, Part part, StudyPoint point) {
        return row.technique().name() + ", " + part.measure.title() + ": " + Numbers.seconds(point.mean(part.measure));
    }
}
