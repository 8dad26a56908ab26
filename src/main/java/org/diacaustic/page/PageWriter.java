package org.diacaustic.page;

import java.util.List;
import java.util.Locale;
import org.diacaustic.chart.Html;

/** Puts a page together. Texts are escaped here, and only here. */
final class PageWriter {
    private final StringBuilder out = new StringBuilder();

    /** Markup as it is. */
    PageWriter add(String markup) {
        out.append(markup).append('\n');
        return this;
    }

    /** Markup with texts for {@code %s}, which are escaped. */
    PageWriter format(String markup, Object... texts) {
        Object[] escaped = new Object[texts.length];
        for (int i = 0; i < texts.length; i++) {
            escaped[i] = texts[i] instanceof String text ? Html.escape(text) : texts[i];
        }
        return add(String.format(Locale.ROOT, markup, escaped));
    }

    /** A section begins. */
    PageWriter section(String key, String title) {
        return format("<section id=\"%s\">", key).format("<h2>%s</h2>", title);
    }

    PageWriter endSection() {
        return add("</section>");
    }

    PageWriter paragraph(String text) {
        return format("<p>%s</p>", text);
    }

    /** A remark on what stands above. */
    PageWriter remark(String text) {
        return format("<p class=\"remark\">%s</p>", text);
    }

    /** A drawing: the wide one where there is room, else the small one. */
    PageWriter chart(Chart chart) {
        if (chart.wide() == chart.small()) {
            return add("<span class=\"chart\">" + chart.wide() + "</span>");
        }
        return add("<span class=\"chart on-wide\">" + chart.wide() + "</span><span class=\"chart on-narrow\">"
                + chart.small() + "</span>");
    }

    /**
     * A table begins.
     *
     * @param style of all of it; {@code numbers} has all columns but the first to the right
     */
    PageWriter table(String style, List<String> heads) {
        add("<div class=\"scroll\"><table class=\"" + style + "\"><thead><tr>");
        heads.forEach(head -> format("<th>%s</th>", head));
        return add("</tr></thead><tbody>");
    }

    /** A row of a table, texts only; the first is its head. */
    PageWriter row(List<String> cells) {
        add("<tr>");
        for (int i = 0; i < cells.size(); i++) {
            format(i == 0 ? "<th>%s</th>" : "<td>%s</td>", cells.get(i));
        }
        return add("</tr>");
    }

    PageWriter endTable() {
        return add("</tbody></table></div>");
    }

    @Override
    public String toString() {
        return out.toString();
    }
}
