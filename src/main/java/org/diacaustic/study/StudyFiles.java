package org.diacaustic.study;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.WholeFile;

/** Puts a study into a folder: {@code study.json}, {@code error.svg} if there is an error to draw, the reference, and every picture as PFM and, at one exposure, as PNG. */
final class StudyFiles {
    static final String REFERENCE = "reference.pfm";

    static final String COUNTED = "counted.png";

    private static final String PICTURES = "pictures";

    private final StudyReport report;
    private final Path folder;

    StudyFiles(StudyReport report, Path folder) {
        this.report = report;
        this.folder = folder;
    }

    /** The file of a picture in the folder, without its ending. */
    static String picture(Technique technique, StudyRun run) {
        return PICTURES + "/" + technique.name() + "-" + run.rays();
    }

    Path write() throws IOException {
        Files.createDirectories(folder.resolve(PICTURES));
        Exposure exposure = Exposure.auto(report.reference().picture());
        report.reference().write(folder.resolve(REFERENCE));
        ImageFiles.write(report.reference().picture(), exposure, folder.resolve("reference.png"));
        ImageFiles.write(report.counted(), Exposure.fixed(1), folder.resolve(COUNTED));
        for (TechniqueStudy study : report.studies()) {
            for (StudyRun run : study.runs()) {
                String name = picture(study.technique(), run);
                ImageFiles.write(run.picture(), exposure, folder.resolve(name + ".pfm"));
                ImageFiles.write(run.picture(), exposure, folder.resolve(name + ".png"));
            }
        }
        if (ErrorChart.hasSomething(report.studies())) {
            writeText(folder.resolve("error.svg"), new ErrorChart(report.studies()).svg());
        }
        Path json = folder.resolve("study.json");
        writeText(json, new StudyJson(report).text());
        return json;
    }

    private static void writeText(Path file, String text) throws IOException {
        WholeFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }
}
