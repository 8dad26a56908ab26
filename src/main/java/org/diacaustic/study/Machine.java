package org.diacaustic.study;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/**
 * What a study ran on.
 *
 * @param system operating system and architecture
 * @param processor its name; empty if the system does not tell
 * @param cores that the virtual machine may use
 * @param java virtual machine and version
 * @param program version of Diacaustic
 */
public record Machine(String system, String processor, int cores, String java, String program) {
    private static final Path LINUX_PROCESSORS = Path.of("/proc/cpuinfo");

    /** @param program version of Diacaustic */
    public static Machine here(String program) {
        return new Machine(
                System.getProperty("os.name") + " " + System.getProperty("os.arch"),
                processorName(),
                Runtime.getRuntime().availableProcessors(),
                System.getProperty("java.vm.name") + " " + System.getProperty("java.runtime.version"),
                program);
    }

    private static String processorName() {
        try (Stream<String> lines = Files.lines(LINUX_PROCESSORS)) {
            return lines.filter(line -> line.startsWith("model name"))
                    .map(line -> line.substring(line.indexOf(':') + 1).strip())
                    .findFirst()
                    .orElse("");
        } catch (IOException notThere) {
            return "";
        }
    }
}
