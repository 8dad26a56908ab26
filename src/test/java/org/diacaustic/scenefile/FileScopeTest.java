package org.diacaustic.scenefile;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.diacaustic.scenefile.Problem.Kind;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FileScopeTest {
    @TempDir
    Path outer;

    private final Problems problems = new Problems();
    private Path scene;
    private Path secret;

    @BeforeEach
    void makeFolders() throws IOException {
        Path inner = Files.createDirectories(outer.resolve("scenes/parts")).getParent();
        scene = inner.resolve("scene.yaml");
        Files.writeString(inner.resolve("parts/cup.obj"), "v 0 0 0\n");
        secret = Files.writeString(outer.resolve("secret.txt"), "password");
    }

    private Path ask(String name, boolean confined) throws IOException {
        Files.writeString(scene, "file: \"" + name + "\"\n");
        FileScope scope = confined ? FileScope.inFolderOf(scene) : FileScope.anywhere(scene);
        return SceneDocument.read(scene, scope, problems).root().file("file").required();
    }

    @Test
    void file_givenNameInsideTheFolder_resolvesIt() throws IOException {
        assertThat(ask("parts/../parts/cup.obj", true)).isEqualTo(scene.resolveSibling("parts/cup.obj"));
        assertThat(ask(scene.resolveSibling("parts/cup.obj").toString(), true)).exists();
        assertThat(problems.sorted()).isEmpty();
    }

    @Test
    void file_givenPathOutOfTheFolder_isRefusedWhetherItExistsOrNot() throws IOException {
        ask("../secret.txt", true);
        ask("../nothing-there.txt", true);
        ask(secret.toString(), true);

        assertThat(problems.sorted()).hasSize(3).allSatisfy(problem -> {
            assertThat(problem.kind()).isEqualTo(Kind.BAD_INPUT);
            assertThat(problem.toString())
                    .contains(":1:7: file: the file lies outside the scene's folder")
                    .doesNotContain("password");
        });
    }

    @Test
    void file_givenSymbolicLinkOutOfTheFolder_isRefused() throws IOException {
        Files.createSymbolicLink(scene.resolveSibling("link.txt"), secret);
        Files.createSymbolicLink(scene.resolveSibling("up"), outer);
        ask("link.txt", true);
        ask("up/secret.txt", true);

        assertThat(problems.sorted())
                .hasSize(2)
                .allSatisfy(problem -> assertThat(problem.message()).contains("outside the scene's folder"));
    }

    @Test
    void file_givenSceneFolderThatIsALink_allowsWhatLiesInIt() throws IOException {
        Path link = Files.createSymbolicLink(outer.resolve("linked"), scene.getParent());
        scene = link.resolve("scene.yaml");

        assertThat(ask("parts/cup.obj", true)).exists();
        assertThat(problems.sorted()).isEmpty();
    }

    @Test
    void file_givenLeaveToGoAnywhere_resolvesOutside() throws IOException {
        assertThat(ask("../secret.txt", false)).isEqualTo(secret);
        assertThat(problems.sorted()).isEmpty();
    }

    @Test
    void file_givenMissingFile_isAFileProblemThatShowsTheResolvedPath() throws IOException {
        ask("parts/nofile.png", true);

        assertThat(problems)
                .hasToString(scene + ":1:7: file: no such file: " + scene.resolveSibling("parts/nofile.png"));
        assertThat(problems.exitCode()).isEqualTo(3);
    }

    @Test
    void file_givenNameThatIsNoPath_isRefused() throws IOException {
        ask("a\\0b", true);

        assertThat(problems.toString()).endsWith("file: expected a file name, found 'a\ufffdb'");
    }
}
