package org.diacaustic.reproduction;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.diacaustic.image.ImageFiles;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A run in which the laboratory answers with the thesis' own numbers: what is made of numbers is right. */
class ReproductionTest {
    private static final Set<ThesisScene> ALL = EnumSet.allOf(ThesisScene.class);

    private final FakeLaboratory laboratory = new FakeLaboratory();

    @Test
    void constructor_givenNothingToDo_throws() {
        assertThatIllegalArgumentException().isThrownBy(() -> new Reproduction(Set.of(), 1, 1));
        assertThatIllegalArgumentException().isThrownBy(() -> new Reproduction(ALL, 1, 0));
    }

    @Test
    void run_givenSeeds_runsRandomTechniquesWithEachAndOthersOnce() {
        List<String> progress = new ArrayList<>();
        new Reproduction(Set.of(ThesisScene.REFRACTION), 7, 3, laboratory)
                .run(2, (done, total) -> progress.add(done + "/" + total));

        assertThat(laboratory.asked)
                .containsExactlyInAnyOrder(
                        "refraction: non-transparent shading 7 with picture",
                        "refraction: non-refractive shading 7 with picture",
                        "refraction: monte-carlo random, individual ambient maps 7 with picture",
                        "refraction: monte-carlo random, individual ambient maps 8",
                        "refraction: monte-carlo random, individual ambient maps 9",
                        "refraction: planar interpolation, individual ambient maps 7 with picture",
                        "refraction: adaptive spherical interpolation, individual ambient maps 7 with picture",
                        "refraction: monte-carlo random, a global photon map 7 with picture",
                        "refraction: monte-carlo random, a global photon map 8",
                        "refraction: monte-carlo random, a global photon map 9",
                        "refraction: planar interpolation, a global photon map 7 with picture",
                        "refraction: adaptive spherical interpolation, a global photon map 7 with picture");
        assertThat(progress).hasSize(12).startsWith("1/12").endsWith("12/12");
    }

    @Test
    void run_givenCancel_stopsAndFails() {
        AtomicReference<Reproduction> running = new AtomicReference<>();
        Reproduction reproduction = new Reproduction(ALL, 1, 2, laboratory);
        running.set(reproduction);
        assertThatIllegalStateException()
                .isThrownBy(
                        () -> reproduction.run(1, (done, total) -> running.get().cancel()));
        assertThat(laboratory.asked).hasSize(1);
    }

    @Test
    void run_givenTheThesisOwnNumbers_findsNoDifference() {
        ReproductionReport report = new Reproduction(ALL, 5, 3, laboratory).run(1, (done, total) -> {});

        int cells = 0;
        for (Comparison comparison : report.comparisons()) {
            for (Comparison.Row row : comparison.rows()) {
                for (Cell cell : row.cells()) {
                    boolean isMoved = cell.quantity() == Quantity.STORED
                            && row.published().method().isRandom();
                    if (isMoved) {
                        // Seeds 5, 6 and 7 are added: mean 6, standard deviation 1.
                        assertThat(cell.ours().mean())
                                .isEqualTo(cell.published().orElseThrow() + 6);
                        assertThat(cell.ours().deviation()).isEqualTo(1);
                        assertThat(cell.deviations()).contains(6.0);
                    } else {
                        assertThat(cell.difference().orElse(0.0)).isZero();
                    }
                    cells++;
                }
            }
        }
        assertThat(cells).isEqualTo(6 * 4 + 22 * 6 + 11 * 4);
        assertThat(report.figures())
                .extracting(Figure::number)
                .startsWith(4, 5, 6, 7)
                .endsWith(33)
                .hasSize(30);
    }

    @Test
    void write_givenReport_makesAPageThatNeedsNothingElse(@TempDir Path folder) throws IOException {
        ReproductionReport report = new Reproduction(ALL, 1, 2, laboratory).run(1, (done, total) -> {});
        Path page = report.write(folder.resolve("new"));

        String html = Files.readString(page);
        // The laboratory moves what is stored in eight rows of random techniques.
        assertThat(html)
                .doesNotContain("http")
                .doesNotContain("NaN")
                .contains(
                        "Of 178 published numbers 170 came out the same",
                        "Table 14.",
                        "7,710,996",
                        "prefers-color-scheme");
        Matcher images = Pattern.compile("<img src=\"([^\"]{30})").matcher(html);
        assertThat(images.results().map(match -> match.group(1)))
                .hasSize(27)
                .allMatch(address -> address.startsWith("data:image/png;base64,"));
        assertThat(html.split("<svg").length - 1).isEqualTo(3);
        assertThat(ImageFiles.read(folder.resolve("new/figures/figure-33.tga")).width())
                .isEqualTo(4);
        assertThat(folder.resolve("new/figures/figure-04.png")).exists();
        assertThat(Files.readString(folder.resolve("new/scenes/complex.yaml")))
                .isEqualTo(Files.readString(Path.of("scenes/complex.yaml")));
    }

    @Test
    void write_givenReport_givesTheSameAsData(@TempDir Path folder) throws IOException {
        new Reproduction(Set.of(ThesisScene.CONTROL), 1, 2, laboratory)
                .run(1, (done, total) -> {})
                .write(folder);

        JsonNode json =
                new ObjectMapper().readTree(folder.resolve("reproduction.json").toFile());
        JsonNode first =
                json.path("tables").path(0).path("rows").path(0).path("values").path("eyeTests");
        assertThat(first.path("published").asDouble()).isEqualTo(201_996);
        assertThat(first.path("mean").asDouble()).isEqualTo(201_996);
        assertThat(json.path("tables")).hasSize(4);
        assertThat(json.path("statements")).hasSize(14);
        assertThat(json.path("figures")).hasSize(13);
        JsonNode random =
                json.path("tables").path(1).path("rows").path(0).path("values").path("stored");
        assertThat(random.path("values")).hasSize(2);
    }
}
