package org.diacaustic.cli;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import org.diacaustic.image.ImageTooLargeException;
import org.diacaustic.render.PlanException;
import org.diacaustic.render.ResourceLimitException;
import org.diacaustic.stability.CaseFileException;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/** Turns what went wrong into one line on standard error and an exit code. */
final class Failures {
    private Failures() {}

    static int usage(ParameterException failure, String[] arguments) {
        CommandLine command = failure.getCommandLine();
        String name = command.getCommandSpec().qualifiedName();
        System.err.println(name + ": " + oneLine(failure.getMessage()) + advice(failure, name));
        return ExitCode.BAD_INPUT;
    }

    private static String advice(ParameterException failure, String name) {
        if (failure instanceof UnmatchedArgumentException unmatched
                && !unmatched.getSuggestions().isEmpty()) {
            return "; did you mean '" + unmatched.getSuggestions().get(0) + "'?";
        }
        return "; see " + name + " --help";
    }

    static int execution(Exception failure, CommandLine command, CommandLine.ParseResult parsed) {
        int code = exitCode(failure);
        if (failure instanceof ProblemsFailure problems) {
            System.err.println(problems.getMessage());
        } else {
            System.err.println("diacaustic: " + message(failure, code));
        }
        if (isDebugging(parsed)) {
            failure.printStackTrace();
        }
        return code;
    }

    static int memory(OutOfMemoryError failure) {
        long mebibytes = Runtime.getRuntime().maxMemory() >> 20;
        System.err.println("diacaustic: out of memory (" + oneLine(String.valueOf(failure.getMessage()))
                + "); java may use " + mebibytes + " MiB, and more with -Xmx");
        return ExitCode.LIMIT;
    }

    static int exitCode(Throwable failure) {
        if (failure instanceof CommandFailure known) {
            return known.exitCode();
        }
        if (failure instanceof PlanException
                || failure instanceof CaseFileException
                || failure instanceof IllegalArgumentException) {
            return ExitCode.BAD_INPUT;
        }
        if (failure instanceof ResourceLimitException || failure instanceof ImageTooLargeException) {
            return ExitCode.LIMIT;
        }
        return failure instanceof IOException ? ExitCode.FILE : ExitCode.INTERNAL;
    }

    private static String message(Exception failure, int code) {
        if (code == ExitCode.INTERNAL) {
            return "internal failure: " + oneLine(failure.toString()) + "; --debug shows where";
        }
        if (failure instanceof FileSystemException file) {
            return file.getFile() + ": " + reason(file);
        }
        return oneLine(String.valueOf(failure.getMessage()));
    }

    private static String reason(FileSystemException failure) {
        if (failure.getReason() != null) {
            return failure.getReason();
        }
        if (failure instanceof NoSuchFileException) {
            return "there is no such file";
        }
        return failure instanceof AccessDeniedException
                ? "access is denied"
                : failure.getClass().getSimpleName();
    }

    private static String oneLine(String message) {
        return message.strip().replaceAll("\\s*\\R\\s*", "; ");
    }

    private static boolean isDebugging(CommandLine.ParseResult parsed) {
        CommandLine.ParseResult innermost = parsed;
        while (innermost.hasSubcommand()) {
            innermost = innermost.subcommand();
        }
        return innermost.hasMatchedOption("--debug");
    }
}
