package org.diacaustic.study;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.LinearImage;
import org.diacaustic.image.WholeFile;

/**
 * Where a study is kept while it runs: every finished point in a file of its own, so that a study that was stopped goes on where
 * it was. What the study was asked for stands beside them, so that points of different studies are never mixed.
 */
public final class StudyFolder implements StudyPictures {
    /** The folder within for drawings, with what separates it from their names. */
    public static final String CHARTS = "charts/";

    static final String REFERENCE = "reference.pfm";

    private static final String POINTS = "points";
    private static final String PICTURES = "pictures";
    private static final String IDENTITY = "identity.json";
    private static final String REFERENCE_FACTS = "reference.json";

    private final Path folder;

    private final Map<String, String> identity;
    private final boolean isNew;

    private StudyFolder(Path folder, Map<String, String> identity, boolean isNew) {
        this.folder = folder;
        this.identity = identity;
        this.isNew = isNew;
    }

    /**
     * Opens a folder, which is made if it is not there.
     *
     * @param identity everything on which the numbers of a point depend, in words
     * @param isNew whether what is kept there is to be forgotten, as soon as there is a reference to begin with
     * @throws IllegalArgumentException if points of another study are there
     * @throws IOException if the folder cannot be read or written
     */
    public static StudyFolder open(Path folder, Map<String, String> identity, boolean isNew) throws IOException {
        for (String within : List.of(POINTS, PICTURES, CHARTS)) {
            Files.createDirectories(folder.resolve(within));
        }
        StudyFolder opened = new StudyFolder(folder, identity, isNew);
        if (!isNew && opened.reference().isPresent()) {
            opened.requireSame(KeptJson.texts(Files.readString(opened.kept(IDENTITY))));
        }
        return opened;
    }

    private void requireSame(Map<String, String> there) {
        for (Map.Entry<String, String> entry : identity.entrySet()) {
            String other = there.getOrDefault(entry.getKey(), "nothing");
            if (!other.equals(entry.getValue())) {
                throw new IllegalArgumentException(folder + ": holds a study with " + entry.getKey() + " " + other
                        + ", but this one has " + entry.getValue() + "; take another folder, or --restart");
            }
        }
    }

    private Path kept(String name) {
        return folder.resolve(POINTS).resolve(name);
    }

    /** The folder itself. */
    public Path path() {
        return folder;
    }

    /** The reference that was kept; nothing if none was, or if it is to be forgotten. */
    public Optional<Reference> reference() throws IOException {
        if (isNew || !Files.exists(kept(REFERENCE_FACTS)) || !Files.exists(kept(IDENTITY))) {
            return Optional.empty();
        }
        Reference read = Reference.read(folder.resolve(REFERENCE));
        return KeptJson.withFacts(read, Files.readString(kept(REFERENCE_FACTS)));
    }

    /** Begins a study with its reference; what was kept of another is forgotten. */
    public void keep(Reference reference) throws IOException {
        try (Stream<Path> files = Files.list(folder.resolve(POINTS))) {
            for (Path file :
                    files.filter(name -> name.toString().endsWith(".json")).toList()) {
                Files.delete(file);
            }
        }
        reference.write(folder.resolve(REFERENCE));
        ImageFiles.write(reference.picture(), Exposure.auto(reference.picture()), folder.resolve("reference.png"));
        write(kept(IDENTITY), KeptJson.of(identity));
        write(kept(REFERENCE_FACTS), KeptJson.of(reference));
    }

    /** The point that was kept; nothing if none was, or if the technique had other settings then. */
    Optional<StudyPoint> point(Technique technique, Budget budget) throws IOException {
        Path file = pointFile(technique, budget);
        return Files.exists(file) ? KeptJson.point(technique, budget, Files.readString(file)) : Optional.empty();
    }

    /**
     * Keeps a point and the picture of its first seed.
     *
     * @param exposure of the picture where it is shown
     */
    void keep(Technique technique, StudyPoint point, LinearImage picture, Exposure exposure) throws IOException {
        ImageFiles.write(picture, exposure, pictureFile(technique, point.budget(), ".pfm"));
        ImageFiles.write(picture, exposure, pictureFile(technique, point.budget(), ".png"));
        write(pointFile(technique, point.budget()), KeptJson.of(technique, point));
    }

    @Override
    public Optional<LinearImage> picture(Technique technique, StudyPoint point) {
        Path file = pictureFile(technique, point.budget(), ".pfm");
        try {
            return Files.exists(file) ? Optional.of(ImageFiles.read(file)) : Optional.empty();
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private Path pointFile(Technique technique, Budget budget) {
        return kept(technique.name() + "@" + budget.label() + ".json");
    }

    private Path pictureFile(Technique technique, Budget budget, String ending) {
        return folder.resolve(PICTURES).resolve(technique.name() + "-" + budget.label() + ending);
    }

    /**
     * Writes a text under a name, beside the pictures or in {@link #CHARTS}.
     *
     * @return the file
     */
    public Path write(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        write(file, text);
        return file;
    }

    private static void write(Path file, String text) throws IOException {
        WholeFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }
}
