package org.diacaustic.stability;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * How processes of the program are started.
 *
 * @param java the virtual machine that runs this process
 * @param program what is said to it, up to the program's own arguments: class path and main class
 * @param otherJava another virtual machine to hold this one against; empty if there is none
 */
public record Launcher(Path java, List<String> program, Optional<Path> otherJava) {
    public Launcher {
        program = List.copyOf(program);
    }
}
