package org.diacaustic.study;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.diacaustic.image.LinearImage;

/**
 * What a study found.
 *
 * @param counted white where pixels counted, black elsewhere
 */
public record StudyReport(Reference reference, LinearImage counted, List<TechniqueStudy> studies, int threads) {

    public StudyReport {
        studies = List.copyOf(studies);
    }

    /** The numbers as text in columns, one line a picture. */
    public String table() {
        return new StudyTable(this).text();
    }

    /**
     * Writes {@code study.json}, the reference and the pictures into a folder, which is made if it is not there.
     *
     * @return the JSON file
     * @throws IOException if that fails
     */
    public Path write(Path folder) throws IOException {
        return new StudyFiles(this, folder).write();
    }
}
