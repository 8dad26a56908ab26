package org.diacaustic.cli;

import java.io.IOException;
import java.util.concurrent.Callable;
import org.diacaustic.json.JsonWriter;
import org.diacaustic.render.Decision;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.scenefile.SceneFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code plan}: what a render will run and what it leaves out, each with its reason. */
@Command(
        name = "plan",
        mixinStandardHelpOptions = true,
        versionProvider = Version.class,
        description = "Says what a render of the scene will run, what it leaves out, and why.")
final class PlanCommand implements Callable<Integer> {
    @Mixin
    private SceneOptions options;

    @Option(names = "--json", description = "As JSON.")
    private boolean json;

    @Override
    public Integer call() throws IOException {
        SceneFile file = options.read();
        RenderPlan plan = RenderPlan.of(file.scene(), file.settings());
        if (json) {
            JsonWriter writer = new JsonWriter();
            writer.beginObject();
            PlanJson.write(plan, writer);
            writer.end();
            System.out.print(writer);
        } else {
            for (Decision decision : plan.decisions()) {
                System.out.println(decision);
            }
        }
        return ExitCode.DONE;
    }
}
