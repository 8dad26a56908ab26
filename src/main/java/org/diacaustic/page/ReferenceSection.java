package org.diacaustic.page;

import java.util.Optional;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.LinearImage;
import org.diacaustic.study.Reference;
import org.diacaustic.study.StudyPoint;
import org.diacaustic.study.StudyReport;

/** What the pictures were held against, and how good that is. */
final class ReferenceSection {
    private static final double SCALE_PER_ERROR = 2.5;

    private final StudyReport report;
    private final PageImages images;
    private final ErrorMaps maps;

    ReferenceSection(StudyReport report, PageImages images) {
        this.report = report;
        this.images = images;
        maps = new ErrorMaps(report);
    }

    void write(PageWriter page) {
        Reference reference = report.reference();
        page.section("reference", "The reference");
        page.paragraph(origin(reference));
        page.paragraph(error(reference));
        page.add("<div class=\"strip large\">");
        Exposure exposure = Exposure.auto(reference.picture());
        figure(page, "the reference itself", reference.picture(), exposure, "");
        figure(page, "the pixels that count", report.counted(), Exposure.fixed(1), counted());
        Optional<LinearImage> halves = reference.halves();
        if (halves.isPresent()) {
            double rms = report.rootMeanSquare(halves.get());
            double scale = ErrorMaps.roundAbove(SCALE_PER_ERROR * rms);
            figure(
                    page,
                    "how its halves differ",
                    maps.ofHalves(halves.get(), scale),
                    Exposure.fixed(1),
                    Numbers.percent(rms) + " as a root mean square; full colour is " + Numbers.roundPercent(scale)
                            + " of the mean");
        }
        page.add("</div>");
        page.endSection();
    }

    private static String origin(Reference reference) {
        return switch (reference.origin()) {
            case STRAIGHT_RAYS ->
                "Nothing in this scene bends light, so straight rays from surfaces to lamps are exact. It was"
                        + " made with " + Numbers.count(reference.rays()) + " eye rays in "
                        + Numbers.seconds(reference.seconds())
                        + "; all that chance is left to are pixels that a shadow's edge cuts.";
            case LIGHT_TRACED ->
                "Light was traced from the lamps and every photon put into the pixel that sees it, without any map,"
                        + " kernel or cell: so it owes nothing to what it judges and is right on average. "
                        + Numbers.count(reference.rays()) + " light rays in " + reference.batches()
                        + " independent batches took " + Numbers.seconds(reference.seconds()) + ".";
            case GIVEN -> "It was read from a file; how it was made is not known here.";
        };
    }

    private String error(Reference reference) {
        if (reference.standardError().isEmpty()) {
            return "How far it may be off itself is not known, so all errors are shown as they were measured.";
        }
        return "Its own error is "
                + Numbers.percent(
                        report.rootMeanSquare(reference.standardError().get()))
                + " of the mean, which its batches tell. That is taken off what is measured, and errors less than "
                + Math.round(StudyPoint.REFERENCE_MARGIN) + " times as large are drawn hollow.";
    }

    private String counted() {
        float[] samples = report.counted().samples();
        int count = 0;
        for (int i = 0; i < samples.length; i += 3) {
            count += samples[i] > 0 ? 1 : 0;
        }
        return Numbers.count(count) + " of " + Numbers.count(samples.length / 3.0)
                + ": those that show one diffuse surface and nothing else";
    }

    private void figure(PageWriter page, String name, LinearImage picture, Exposure exposure, String words) {
        if (!images.has(name)) {
            images.put(name, picture, exposure);
        }
        page.format(
                "<figure><span class=\"pixels %s\" role=\"img\" aria-label=\"%s\"></span>", images.style(name), name);
        page.format("<figcaption><b>%s</b><span>%s</span></figcaption></figure>", name, words);
    }
}
