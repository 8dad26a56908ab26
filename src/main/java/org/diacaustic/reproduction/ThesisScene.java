package org.diacaustic.reproduction;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneDocument;
import org.diacaustic.scenefile.SceneFile;
import org.diacaustic.scenefile.SceneReader;

/** The three scenes that the thesis measures [Thesis 5.3 - 5.5]. */
public enum ThesisScene {
    /** A wavy sheet that bends nothing, over a ball on a floor. */
    CONTROL(4),
    /** The same with water. */
    REFRACTION(5),
    /** A box of water seen from inside, with an ellipsoid, a sphere and a fractal. */
    COMPLEX(6);

    private final int costChart;

    ThesisScene(int costChart) {
        this.costChart = costChart;
    }

    /** The name that tables, files and the command line use. */
    public String key() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The number of the figure that compares the costs of pre-processing. */
    int costChart() {
        return costChart;
    }

    /** The scene file as it is kept with the program. */
    String text() {
        String name = key() + ".yaml";
        try (InputStream in = ThesisScene.class.getResourceAsStream(name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new IllegalStateException(name + " cannot be read from the program's own files", e);
        }
    }

    SceneFile read() {
        Problems problems = new Problems();
        SceneDocument document = SceneDocument.parse(key() + ".yaml", text(), problems);
        return SceneReader.read(document, problems).orElseThrow(() -> new IllegalStateException(problems.toString()));
    }
}
