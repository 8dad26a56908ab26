package org.diacaustic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ReproduceCommandTest {

    @Test
    void reproduce_givenNoFolder_isRefused(@TempDir Path folder) throws IOException {
        assertThat(Cli.run("reproduce").code()).isEqualTo(2);
        Path file = Files.writeString(folder.resolve("notes.txt"), "mine");
        Cli.Result result = Cli.run("reproduce", "-o", file);
        assertThat(result.code()).isEqualTo(3);
        assertThat(result.errorLines()).containsExactly("diacaustic: " + file + ": is a file, not a folder");
        assertThat(Files.readString(file)).isEqualTo("mine");
    }

    @Test
    void reproduce_givenUnknownScene_namesTheKnownOnes(@TempDir Path folder) {
        Cli.Result result = Cli.run("reproduce", "-o", folder, "--scene", "contro");
        assertThat(result.code()).isEqualTo(2);
        assertThat(result.err()).contains("control, refraction, complex");
    }

    @Test
    void reproduce_givenOneSceneQuickly_writesItsPageDataAndPictures(@TempDir Path folder) throws IOException {
        Path output = folder.resolve("a/b");
        Cli.Result result = Cli.run("reproduce", "-o", output, "--scene", "refraction", "--quick", "--threads", 2);

        assertThat(result.err()).isEmpty();
        assertThat(result.code()).isZero();
        assertThat(result.out()).startsWith(output.resolve("reproduction.html") + ": ");
        JsonNode json =
                new ObjectMapper().readTree(output.resolve("reproduction.json").toFile());
        json.path("identities")
                .forEach(identity -> assertThat(identity.path("holds").asBoolean())
                        .as(identity.path("claim").asText())
                        .isTrue());
        assertThat(json.path("identities")).hasSize(8);
        for (int figure : new int[] {5, 19, 26}) {
            assertThat(output.resolve(String.format("figures/figure-%02d.tga", figure)))
                    .exists();
        }
        assertThat(output.resolve("figures/figure-07.png")).doesNotExist();
    }
}
