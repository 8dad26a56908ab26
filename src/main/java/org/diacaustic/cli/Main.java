package org.diacaustic.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.HelpCommand;

/** {@code java -jar diacaustic.jar}: picks a command; a bare scene file is rendered beside itself. */
@Command(
        name = "diacaustic",
        versionProvider = Version.class,
        mixinStandardHelpOptions = true,
        description = "Renders caustics: light that reaches a surface after being refracted or reflected.",
        synopsisHeading = "Usage: ",
        synopsisSubcommandLabel = "COMMAND",
        customSynopsis = {"diacaustic COMMAND ...", "       diacaustic SCENE   renders SCENE to a .png beside it"},
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:done",
            "1:internal failure",
            "2:bad input or usage",
            "3:a file cannot be read or written",
            "4:a resource limit, or a target that was not reached",
            "130, 143:interrupted; the picture so far is saved"
        },
        subcommands = {
            RenderCommand.class,
            PlanCommand.class,
            CheckCommand.class,
            CompareCommand.class,
            HelpCommand.class
        })
public final class Main {
    private Main() {}

    /** Runs the command line and ends the process with its exit code. */
    public static void main(String[] arguments) {
        System.exit(run(arguments));
    }

    /** Runs the command line and returns its exit code. */
    static int run(String... arguments) {
        CommandLine commandLine = new CommandLine(new Main());
        commandLine.setParameterExceptionHandler(Failures::usage);
        commandLine.setExecutionExceptionHandler(Failures::execution);
        if (arguments.length == 0) {
            commandLine.usage(System.err);
            return ExitCode.BAD_INPUT;
        }
        try {
            return commandLine.execute(namesScene(commandLine, arguments[0]) ? renderBeside(arguments) : arguments);
        } catch (OutOfMemoryError tooSmall) {
            return Failures.memory(tooSmall);
        }
    }

    private static boolean namesScene(CommandLine commandLine, String first) {
        return !first.startsWith("-")
                && !commandLine.getSubcommands().containsKey(first)
                && (Files.exists(Path.of(first)) || first.matches("(?i).*\\.(ya?ml|json)"));
    }

    private static String[] renderBeside(String[] arguments) {
        String[] render = new String[arguments.length + 2];
        render[0] = "render";
        render[1] = RenderCommand.BESIDE;
        System.arraycopy(arguments, 0, render, 2, arguments.length);
        return Arrays.copyOf(render, render.length);
    }
}
