package org.diacaustic.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Supplier;
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
            "4:a resource limit, a target that was not reached (the picture so far is saved), or a case that fails",
            "130, 143:interrupted; the picture so far is saved"
        })
public final class Main {
    private final Map<String, Supplier<Object>> commands;

    private Main(ProcessTime time) {
        commands = commands(time);
    }

    private static Map<String, Supplier<Object>> commands(ProcessTime time) {
        Map<String, Supplier<Object>> commands = new LinkedHashMap<>();
        commands.put("render", () -> new RenderCommand(time));
        commands.put("plan", PlanCommand::new);
        commands.put("check", CheckCommand::new);
        commands.put("compare", CompareCommand::new);
        commands.put("reproduce", ReproduceCommand::new);
        commands.put("study", StudyCommand::new);
        commands.put("stability", StabilityCommand::new);
        commands.put("help", HelpCommand::new);
        return commands;
    }

    /** Runs the command line and ends the process with its exit code. */
    public static void main(String[] arguments) {
        // No option has such a type, and to load them costs a small render a fiftieth.
        System.setProperty("picocli.converters.excludes", "java.sql.*,java.time.*");
        System.exit(new Main(ProcessTime.ofMachine()).execute(arguments));
    }

    /** Runs the command line and returns its exit code. */
    static int run(String... arguments) {
        return new Main(ProcessTime.ofCall()).execute(arguments);
    }

    private int execute(String... arguments) {
        if (arguments.length == 0) {
            commandLine("").usage(System.err);
            return ExitCode.BAD_INPUT;
        }
        String[] words = namesScene(arguments[0]) ? renderBeside(arguments) : arguments;
        try {
            return commandLine(words[0]).execute(words);
        } catch (OutOfMemoryError tooSmall) {
            return Failures.memory(tooSmall);
        }
    }

    /** Knows the command that is asked for; all of them if it is none, or help: each takes a while to describe. */
    private CommandLine commandLine(String asked) {
        CommandLine commandLine = new CommandLine(this);
        boolean one = commands.containsKey(asked) && !asked.equals("help");
        commands.forEach((name, command) -> {
            if (!one || name.equals(asked)) {
                commandLine.addSubcommand(name, command.get());
            }
        });
        commandLine.setParameterExceptionHandler(Failures::usage);
        commandLine.setExecutionExceptionHandler(Failures::execution);
        return commandLine;
    }

    private boolean namesScene(String first) {
        return !first.startsWith("-")
                && !commands.containsKey(first)
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
