package org.diacaustic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class StabilityCommandTest {
    /** Total reflection, and what is not. */
    private static final String CASES = """
            {"schema": "caustics-numerics/1", "cases": [
              {"id": "A-1", "category": "OWN", "title": "dense to thin", "op": "fresnel_scalar",
               "inputs": {"n1": 1.5, "n2": 1.0, "cosI": 0.1},
               "expected": {"tir": true, "R": "1.0", "T": "0.0"}, "tolerance": {"R_abs": 0, "T_abs": 0}},
              {"id": "A-2", "category": "OWN", "title": "straight on", "op": "fresnel_scalar",
               "inputs": {"n1": 1.0, "n2": 1.5, "cosI": 1.0},
               "expected": {"tir": false, "R": "0.04", "T": "0.96"}, "tolerance": {"R_abs": 1e-15, "T_abs": 1e-15}}
            ]}
            """;

    private static void refused(int code, String line, Object... arguments) {
        Cli.Result result = Cli.run(arguments);
        assertThat(result.errorLines()).hasSize(1).first().asString().contains(line);
        assertThat(result.code()).isEqualTo(code);
        assertThat(result.out()).isEmpty();
    }

    @Test
    void stability_givenWhatCannotBe_saysItInOneLine(@TempDir Path folder) throws IOException {
        refused(2, "--category must be one of ACCUM, ", "stability", "--category", "NONE");
        refused(2, "--threads must be at least 0", "stability", "--threads", -1);
        refused(2, "--random must be at least 0", "stability", "--random", -1);
        refused(2, "--jdk must be the home of a JDK", "stability", "--jdk", folder);
        refused(3, "none.json: there is no such file", "stability", "--cases", folder.resolve("none.json"));
        Path other = Files.writeString(folder.resolve("other.json"), "{\"schema\": 1}");
        refused(2, "schema should be caustics-numerics/1", "stability", "--cases", other);
        refused(3, "is a file, not a folder", "stability", "--category", "UV", "-o", other);
    }

    @Test
    void stability_givenCasesOfOnesOwn_runsThem(@TempDir Path folder) throws IOException {
        Path cases = Files.writeString(folder.resolve("cases.json"), CASES);
        Path out = folder.resolve("out");
        Cli.Result result = Cli.run("stability", "--cases", cases, "-o", out);
        assertThat(result.code()).isZero();
        assertThat(result.err()).isEmpty();
        assertThat(result.out().lines()).hasSize(4);
        assertThat(result.out()).contains("A-1  dense to thin  ").contains("2 cases, 2 pass; ");
        assertThat(out.resolve("stability.json")).content().contains("\"id\": \"A-2\"");
        assertThat(out.resolve("stability.md")).content().contains("| A-2 | straight on |");
    }

    @Test
    void stability_givenAWrongAnswer_failsWithCode4(@TempDir Path folder) throws IOException {
        Path cases = Files.writeString(folder.resolve("cases.json"), CASES.replace("0.04", "0.05"));
        Cli.Result result = Cli.run("stability", "--cases", cases);
        assertThat(result.code()).isEqualTo(4);
        assertThat(result.out()).contains("R: expected 0.05, got 0.04").contains("1 pass, 1 FAIL");
    }
}
