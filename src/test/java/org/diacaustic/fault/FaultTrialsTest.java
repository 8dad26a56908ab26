package org.diacaustic.fault;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.diacaustic.parallel.Workers;
import org.diacaustic.stability.CaseResult;
import org.diacaustic.stability.Launcher;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operation;
import org.diacaustic.stability.Operations;
import org.diacaustic.stability.StabilityRun;
import org.diacaustic.stability.Values;
import org.diacaustic.stability.Verdict;
import org.junit.jupiter.api.Test;

/** Faults that are met pass, and what is not as a fault wants it fails. */
class FaultTrialsTest {
    private static final Launcher LAUNCHER = new Launcher(
            Path.of(System.getProperty("java.home"), "bin", "java"),
            List.of("-cp", System.getProperty("java.class.path"), "org.diacaustic.cli.Main"),
            Optional.empty());

    private static CaseResult result(Operations operations, String name) {
        NumericCase asked = new NumericCase(
                "T-1",
                "RELIAB",
                "title",
                "cli_fault:" + name,
                Values.of("inputs", Map.of("variant", "words")),
                Values.of("expected", Map.of()),
                Values.of("tolerance", Map.of()),
                List.of(),
                "");
        return new StabilityRun(operations, EnumSet.allOf(Operation.Need.class))
                .run(List.of(asked), new Workers(1), result -> {})
                .results()
                .get(0);
    }

    private static CaseResult result(FaultOperations.Fault fault) {
        Operations operations = new Operations();
        new FaultOperations(operations, LAUNCHER).add("own", "one of the test", fault);
        return result(operations, "own");
    }

    @Test
    void all_givenFaultsOfText_passes() {
        Operations all = new Operations();
        FaultTrials.addTo(all, LAUNCHER);
        assertThat(result(all, "cycle").verdict()).isEqualTo(Verdict.PASS);
        assertThat(result(all, "clock").verdict()).isEqualTo(Verdict.PASS);
        assertThat(result(all, "killresume").verdict()).isEqualTo(Verdict.NOT_APPLICABLE);
    }

    @Test
    void refuses_givenSceneThatIsSound_fails() {
        CaseResult result = result((bench, asked, checks) -> bench.refuses("a sound scene", FaultScene.TEXT, 2, ""));
        assertThat(result.verdict()).isEqualTo(Verdict.FAIL);
        assertThat(result.worst().got()).startsWith("exit 0 after ").contains("out.png");
    }

    @Test
    void refuses_givenOtherCodeOrWords_fails() {
        String broken = FaultScene.with(FaultScene.RADIUS, "radius: -1");
        assertThat(result((bench, asked, checks) -> bench.refuses("", broken, 2, "above 0"))
                        .verdict())
                .isEqualTo(Verdict.PASS);
        assertThat(result((bench, asked, checks) -> bench.refuses("", broken, 3, "above 0"))
                        .verdict())
                .isEqualTo(Verdict.FAIL);
        assertThat(result((bench, asked, checks) -> bench.refuses("", broken, 2, "below 0"))
                        .verdict())
                .isEqualTo(Verdict.FAIL);
    }

    @Test
    void renders_givenBrokenSceneOrUnexpectedWords_fails() {
        String broken = FaultScene.with(FaultScene.RADIUS, "radius: -1");
        assertThat(result((bench, asked, checks) -> bench.renders("", broken, ""))
                        .verdict())
                .isEqualTo(Verdict.FAIL);
        String dark = FaultScene.without("lights:", "materials:");
        assertThat(result((bench, asked, checks) -> bench.renders("", dark, "")).verdict())
                .isEqualTo(Verdict.FAIL);
    }

    @Test
    void close_givenFilesAndLinks_leavesNothing() throws Exception {
        Path[] folder = new Path[1];
        result((bench, asked, checks) -> {
            folder[0] = bench.folder();
            bench.scene(FaultScene.TEXT);
            Files.createSymbolicLink(
                    bench.folder().resolve("up"), bench.folder().getParent());
            checks.holds("it is there", Files.exists(bench.folder()));
        });
        assertThat(folder[0].getParent()).doesNotExist();
    }
}
