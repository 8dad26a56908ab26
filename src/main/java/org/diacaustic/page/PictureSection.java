package org.diacaustic.page;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.diacaustic.chart.Html;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.LinearImage;
import org.diacaustic.study.Measure;
import org.diacaustic.study.StudyPictures;
import org.diacaustic.study.StudyPoint;
import org.diacaustic.study.StudyReport;
import org.diacaustic.study.Technique;
import org.diacaustic.study.TechniqueStudy;

/** Pictures of equal time and of equal error, their error maps, and a viewer that lays two over each other. */
final class PictureSection {
    private static final String REFERENCE = "reference";

    /** The full colour of error maps is this many times the middle one of the errors shown. */
    private static final double SCALE_PER_ERROR = 2;

    private final StudyReport report;
    private final StudyPictures pictures;
    private final PageImages images;
    private final ErrorMaps maps;
    private final Exposure exposure;
    private final List<TechniqueStudy> shown;
    private final List<TechniqueStudy> others;
    private final EqualChoice equalTime;
    private final EqualChoice equalError;
    private final double scale;

    /** What the viewer can show: words for it, by the styles of picture and map. */
    private final Map<String, String> views = new LinkedHashMap<>();

    PictureSection(StudyReport report, ShownTechniques techniques, StudyPictures pictures, PageImages images) {
        this.report = report;
        this.pictures = pictures;
        this.images = images;
        maps = new ErrorMaps(report);
        exposure = Exposure.auto(report.reference().picture());
        shown = techniques.shown();
        others = techniques.others();
        equalTime = EqualChoice.ofTime(shown);
        equalError = EqualChoice.ofError(shown);
        double[] errors = DoubleStream.concat(
                        equalTime.points().values().stream().mapToDouble(StudyPoint::shownError),
                        equalError.points().values().stream().mapToDouble(StudyPoint::shownError))
                .sorted()
                .toArray();
        scale = errors.length == 0 ? 1 : ErrorMaps.roundAbove(SCALE_PER_ERROR * errors[errors.length / 2]);
    }

    void write(PageWriter page) {
        page.section("pictures", "Pictures");
        LinearImage reference = report.reference().picture();
        put(REFERENCE, reference);
        views.put(view(REFERENCE), REFERENCE);
        PageWriter strips = new PageWriter();
        strip(
                strips,
                "Equal time: at most " + Numbers.seconds(equalTime.limit()) + " of processors",
                shown,
                equalTime,
                Comparator.comparingDouble(StudyPoint::shownError));
        strip(
                strips,
                "Equal error: at most " + Numbers.percent(equalError.limit()),
                shown,
                equalError,
                Comparator.comparingDouble(point -> point.mean(Measure.PROCESSOR_SECONDS)));
        if (!others.isEmpty()) {
            strips.format("<details><summary>the other %d techniques at equal time</summary>", others.size());
            EqualChoice choice = EqualChoice.withinTime(others, equalTime.limit());
            strip(strips, "", others, choice, Comparator.comparingDouble(StudyPoint::shownError));
            strips.add("</details>");
        }
        viewer(page);
        page.add("<div class=\"key\"><span>too dark</span><span>" + "−" + Numbers.roundPercent(scale) + "</span>");
        images.put("ramp", ErrorMaps.ramp(), Exposure.fixed(1));
        page.add("<span class=\"ramp " + images.style("ramp") + "\"></span>");
        page.add("<span>+" + Numbers.roundPercent(scale)
                + " of the mean</span><span>too bright</span><span>dim: does not count</span></div>");
        page.add(strips.toString());
        page.remark(
                "Pictures are of the first seed, and all have one exposure, that of the reference. Error maps have one scale.");
        page.endSection();
    }

    private void put(String key, LinearImage picture) {
        if (!images.has(key)) {
            images.put(key, picture, exposure);
            images.put(mapKey(key), maps.of(picture, report.reference().picture(), scale), Exposure.fixed(1));
        }
    }

    private static String mapKey(String key) {
        return "map of " + key;
    }

    private String view(String key) {
        return images.style(key) + " " + images.style(mapKey(key));
    }

    private void strip(
            PageWriter page,
            String title,
            List<TechniqueStudy> studies,
            EqualChoice choice,
            Comparator<StudyPoint> order) {
        page.add(title.isEmpty() ? "" : "<h3>" + Html.escape(title) + "</h3>").add("<div class=\"strip\">");
        figure(page, REFERENCE, REFERENCE, "");
        List<String> missing = new ArrayList<>();
        List<Map.Entry<TechniqueStudy, StudyPoint>> entries =
                new ArrayList<>(choice.points().entrySet());
        entries.sort(Map.Entry.comparingByValue(order));
        for (Map.Entry<TechniqueStudy, StudyPoint> entry : entries) {
            Technique technique = entry.getKey().technique();
            StudyPoint point = entry.getValue();
            Optional<LinearImage> picture = pictures.picture(technique, point);
            if (picture.isEmpty()) {
                missing.add(technique.name());
                continue;
            }
            String key = technique.name() + " " + point.budget().label();
            put(key, picture.get());
            String numbers =
                    Numbers.seconds(point.mean(Measure.PROCESSOR_SECONDS)) + ", " + Numbers.percent(point.shownError());
            views.putIfAbsent(view(key), technique.name() + ", " + numbers);
            figure(page, key, technique.name(), numbers);
        }
        page.add("</div>");
        studies.stream()
                .filter(study -> !choice.points().containsKey(study))
                .map(study -> study.technique().name())
                .forEach(missing::add);
        if (!missing.isEmpty()) {
            page.remark("No picture here: " + missing.stream().sorted().collect(Collectors.joining(", ")) + ".");
        }
    }

    private void figure(PageWriter page, String key, String name, String numbers) {
        page.format("<figure data-view=\"%s\" tabindex=\"0\">", view(key));
        page.format("<span class=\"pixels %s\" role=\"img\" aria-label=\"%s\"></span>", images.style(key), name);
        page.format(
                "<span class=\"pixels %s\" role=\"img\" aria-label=\"error of %s\"></span>",
                images.style(mapKey(key)), name);
        page.format("<figcaption><b>%s</b><span>%s</span></figcaption></figure>", name, numbers);
    }

    /** Needs a script, and is not there without. */
    private void viewer(PageWriter page) {
        LinearImage picture = report.reference().picture();
        page.format(
                "<div id=\"viewer\" hidden><div id=\"stage\" tabindex=\"0\" style=\"aspect-ratio:%d/%d\">",
                picture.width(), picture.height());
        page.add("<span class=\"layer\" id=\"layer-a\"></span><span class=\"layer\" id=\"layer-b\"></span>");
        page.add(
                "<span id=\"divider\"></span><span class=\"tag\" id=\"tag-a\"></span><span class=\"tag\" id=\"tag-b\"></span></div>");
        page.add("<div id=\"controls\">");
        select(page, "a", "left (A)");
        select(page, "b", "right (B)");
        page.add("<label>divide <input type=\"range\" id=\"divide\" min=\"0\" max=\"100\" value=\"50\"></label>");
        page.add("<div class=\"buttons\"><button type=\"button\" id=\"flip\">flip A and B <kbd>space</kbd></button>");
        page.add("<button type=\"button\" id=\"mode\" aria-pressed=\"false\">error maps <kbd>m</kbd></button></div>");
        page.add("<p class=\"remark\">Drag the line, or tap a picture below to see it as B.</p></div></div>");
        page.add(
                "<noscript><p class=\"remark\">With JavaScript two pictures can be laid over each other here.</p></noscript>");
    }

    private void select(PageWriter page, String key, String title) {
        page.format("<label>%s <select id=\"choose-%s\">", title, key);
        views.forEach((view, words) -> page.format("<option value=\"%s\">%s</option>", view, words));
        page.add("</select></label>");
    }
}
