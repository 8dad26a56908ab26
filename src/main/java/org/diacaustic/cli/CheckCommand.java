package org.diacaustic.cli;

import java.io.IOException;
import java.util.concurrent.Callable;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.scene.Scene;
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
        System.out.println(options.path() + ": OK, " + summary(file.scene()));
        return ExitCode.DONE;
    }

    private static String summary(Scene scene) {
        return count(scene.objects().size(), "object") + ", "
                + count(scene.lights().size(), "light") + ", "
                + scene.camera().width() + " x " + scene.camera().height() + " pixels";
    }

    private static String count(int number, String noun) {
        return number + " " + noun + (number == 1 ? "" : "s");
    }
}
