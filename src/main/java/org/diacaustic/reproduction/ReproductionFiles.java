package org.diacaustic.reproduction;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.HashMap;
import java.util.Map;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.WholeFile;

/**
 * Puts a report into a folder: {@code reproduction.html}, which needs nothing else, {@code reproduction.json}, and the
 * folders {@code figures} and {@code scenes}.
 */
final class ReproductionFiles {
    private final ReproductionReport report;
    private final Path folder;

    ReproductionFiles(ReproductionReport report, Path folder) {
        this.report = report;
        this.folder = folder;
    }

    Path write() throws IOException {
        Path figures = Files.createDirectories(folder.resolve("figures"));
        Path scenes = Files.createDirectories(folder.resolve("scenes"));
        for (ThesisScene scene : report.scenes()) {
            write(scenes.resolve(scene.key() + ".yaml"), scene.text());
        }
        Map<Figure, String> images = new HashMap<>();
        for (Figure figure : report.figures()) {
            Path png = figures.resolve(figure.fileName() + ".png");
            ImageFiles.write(figure.picture(), Exposure.fixed(1), png);
            ImageFiles.write(figure.picture(), Exposure.fixed(1), figures.resolve(figure.fileName() + ".tga"));
            images.put(figure, "data:image/png;base64," + Base64.getEncoder().encodeToString(Files.readAllBytes(png)));
        }
        write(folder.resolve("reproduction.json"), new ReproductionJson(report).text());
        Path page = folder.resolve("reproduction.html");
        write(page, new ReproductionPage(report, images).text());
        return page;
    }

    private static void write(Path file, String text) throws IOException {
        WholeFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }
}
