package org.diacaustic.cli;

import java.io.IOException;
import java.util.concurrent.Callable;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code check}: all problems of a scene file; nothing is rendered. */
@Command(
        name = "check",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = "Reports all problems of a scene file; renders nothing.")
final class CheckCommand implements Callable<Integer> {
    @Mixin
    private SceneOptions options;

    @Override
    public Integer call() throws IOException {
        Problems problems = new Problems();
        SceneFile file = options.read(problems);
        String lines = problems.toString();
        if (!lines.isEmpty()) {
            System.out.println(lines);
        }
        if (problems.hasErrors()) {
            return problems.exitCode();
        }
        RenderPlan.of(file.scene(), file.settings());
        System.out.println(
                options.path() + ": no errors; " + file.scene().objects().size() + " objects, "
                        + file.scene().lights().size() + " lights, "
                        + file.scene().camera().width() + " x "
                        + file.scene().camera().height() + " pixels");
        return ExitCode.DONE;
    }
}
