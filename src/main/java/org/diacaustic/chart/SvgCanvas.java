package org.diacaustic.chart;

import java.util.Locale;

/** Draws as SVG, whose colours the page gives by the classes {@code fill-INK} and {@code line-INK}. */
public final class SvgCanvas implements Canvas {
    private final StringBuilder out = new StringBuilder();

    /** @param title what the chart shows, for those who do not see it */
    public SvgCanvas(int width, int height, String title) {
        append(
                "<svg viewBox=\"0 0 %d %d\" role=\"img\" aria-label=\"%s\" font-family=\"sans-serif\" font-size=\"10\" fill=\"%s\">",
                width, height, Html.escape(title), Ink.TEXT.webColor);
    }

    @Override
    public void fill(double x, double y, double width, double height, Ink ink) {
        rectangle(x, y, width, height, "fill=\"" + ink.webColor + "\" class=\"fill-" + ink.key());
    }

    @Override
    public void outline(double x, double y, double width, double height, Ink ink) {
        String paint = "fill=\"none\" stroke=\"" + ink.webColor + "\" class=\"line-" + ink.key();
        rectangle(x + 0.5, y + 0.5, width - 1, height - 1, paint);
    }

    private void rectangle(double x, double y, double width, double height, String paint) {
        append("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" %s\"/>", x, y, width, height, paint);
    }

    @Override
    public void text(double x, double y, String text) {
        append("<text x=\"%.1f\" y=\"%.1f\">%s</text>", x, y, Html.escape(text));
    }

    @Override
    public void textAround(double x, double y, String text) {
        append("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">%s</text>", x, y, Html.escape(text));
    }

    /** One line of text in letters of one's own. */
    public void text(double x, double y, String text, Lettering lettering) {
        append(
                "<text x=\"%.1f\" y=\"%.1f\" font-size=\"%.1f\" fill=\"%s\"%s>%s</text>",
                x, y, lettering.size(), lettering.color(), lettering.attributes(), Html.escape(text));
    }

    /** One line of text with an edge of paper around it, over what is drawn there. */
    public void textOver(double x, double y, String text, Lettering lettering, String paper) {
        append("<g stroke=\"%s\" stroke-width=\"4\" stroke-linejoin=\"round\" paint-order=\"stroke\">", paper);
        text(x, y, text, lettering);
        endGroup();
    }

    /** What follows belongs together, and says what it is when it is pointed at. */
    public void beginGroup(String kind, String title) {
        append("<g class=\"%s\"><title>%s</title>", kind, Html.escape(title));
    }

    public void endGroup() {
        append("</g>");
    }

    /** A filled rectangle. */
    public void fill(double x, double y, double width, double height, String color) {
        rectangle(x, y, width, height, "fill=\"" + color);
    }

    /** A line from point to point. */
    public void line(double[] x, double[] y, double width, String color) {
        line(x, y, width, color, "");
    }

    /** A line from point to point, as dashes and gaps of so many units. */
    public void dashes(double[] x, double[] y, double width, String color, double dash) {
        line(x, y, width, color, String.format(Locale.ROOT, " stroke-dasharray=\"%.1f\"", dash));
    }

    private void line(double[] x, double[] y, double width, String color, String more) {
        append(
                "<polyline points=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"%.1f\"%s/>",
                points(x, y), color, width, more);
    }

    /** The area that a line around it holds, so that what lies below is seen as much as 1 − opacity. */
    public void area(double[] x, double[] y, String color, double opacity) {
        append("<polygon points=\"%s\" fill=\"%s\" fill-opacity=\"%.2f\"/>", points(x, y), color, opacity);
    }

    /** A mark around a place: full, or hollow with paper within. */
    public void mark(Mark mark, double x, double y, double radius, String color, String within) {
        append(
                "<path d=\"%s\" fill=\"%s\" stroke=\"%s\" stroke-width=\"1.5\"/>",
                mark.path(x, y, radius), within, color);
    }

    private static String points(double[] x, double[] y) {
        StringBuilder points = new StringBuilder();
        for (int i = 0; i < x.length; i++) {
            points.append(String.format(Locale.ROOT, "%s%.1f,%.1f", i == 0 ? "" : " ", x[i], y[i]));
        }
        return points.toString();
    }

    /** What follows is measured in units of its own from a rectangle's top left corner, and seen within the rectangle only. */
    public void beginClip(double x, double y, double width, double height, double unit) {
        append(
                "<svg x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" viewBox=\"0 0 %.1f %.1f\">",
                x, y, width, height, width / unit, height / unit);
    }

    public void endClip() {
        append("</svg>");
    }

    /** Thin lines along a path in SVG's own words. */
    public void path(String path, String color) {
        append(
                "<path d=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"0.5\" vector-effect=\"non-scaling-stroke\"/>",
                path, color);
    }

    private void append(String format, Object... values) {
        out.append(String.format(Locale.ROOT, format, values)).append('\n');
    }

    /** The drawing as a file of its own; as {@link #toString} it is a part of a page. */
    public String file() {
        return toString().replaceFirst("<svg ", "<svg xmlns=\"http://www.w3.org/2000/svg\" ");
    }

    @Override
    public String toString() {
        return out + "</svg>\n";
    }
}
