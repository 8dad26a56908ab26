package org.diacaustic.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WholeFileTest {
    @TempDir
    Path folder;

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(f -> f.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void write_givenFailureHalfWay_keepsTheOldFileAndNothingElse() throws IOException {
        Path file = folder.resolve("a.txt");
        Files.writeString(file, "old");
        IOException full = new IOException("disk full");
        assertThatThrownBy(() -> WholeFile.write(file, out -> {
                    out.write(new byte[1 << 20]);
                    throw full;
                }))
                .isSameAs(full);
        assertThat(file).hasContent("old");
        assertThat(names()).containsExactly("a.txt");
    }

    @Test
    void write_givenTargetThatIsAFolder_removesTheTemporaryFile() throws IOException {
        Path taken = folder.resolve("a.txt");
        Files.createDirectory(taken);
        Files.createFile(taken.resolve("inside"));
        assertThatThrownBy(() -> WholeFile.write(taken, out -> out.write(1))).isInstanceOf(IOException.class);
        assertThat(names()).containsExactly("a.txt");
    }

    @Test
    void write_givenMissingFolder_saysSo() {
        Path file = folder.resolve("none").resolve("a.txt");
        assertThatThrownBy(() -> WholeFile.write(file, out -> out.write(1))).isInstanceOf(NoSuchFileException.class);
    }

    @Test
    void write_givenExistingTarget_isUnseenUntilWhole() throws IOException {
        Path file = folder.resolve("a.txt");
        Files.writeString(file, "old");
        WholeFile.write(file, out -> {
            out.write("new".getBytes());
            out.flush();
            assertThat(file).hasContent("old");
        });
        assertThat(file).hasContent("new");
        assertThat(names()).containsExactly("a.txt");
    }

    @Test
    void write_givenAnotherWriterOfTheSameFile_staysApartFromIt() throws IOException {
        Path file = folder.resolve("a.txt");
        WholeFile.write(file, outer -> {
            outer.write('o');
            WholeFile.write(file, inner -> inner.write('i'));
            assertThat(file).hasContent("i");
        });
        assertThat(file).hasContent("o");
        assertThat(names()).containsExactly("a.txt");
    }

    @Test
    void write_givenSymbolicLink_replacesWhatItPointsTo() throws IOException {
        Path real = folder.resolve("real.txt");
        Path link = folder.resolve("link.txt");
        Files.writeString(real, "old");
        Files.createSymbolicLink(link, real);
        WholeFile.write(link, out -> out.write("new".getBytes()));
        assertThat(link).isSymbolicLink();
        assertThat(real).hasContent("new");
    }

    /** An interrupted render still saves its picture. */
    @Test
    void write_givenInterruptedThread_writesAllTheSame() {
        Path file = folder.resolve("a.txt");
        Thread.currentThread().interrupt();
        try {
            WholeFile.write(file, out -> out.write(new byte[1 << 20]));
            assertThat(file).hasSize(1 << 20);
        } catch (IOException e) {
            throw new AssertionError(e);
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }
    }
}
