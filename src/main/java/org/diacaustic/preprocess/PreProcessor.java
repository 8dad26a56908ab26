package org.diacaustic.preprocess;

import java.util.Optional;

/**
 * A way to choose light rays [Thesis 4.1 - 4.7.1]. Implementations are immutable and found by {@link java.util.ServiceLoader},
 * or handed to the plan.
 */
public interface PreProcessor {

    /** The name that settings know it by. */
    String name();

    /** Why it cannot choose rays for this beam, in words that go on after "because"; empty if it can. */
    default Optional<String> refusal(Beam beam) {
        return Optional.empty();
    }

    /**
     * Chooses rays for one beam and has them followed. What it does must depend on the beam, the random numbers that it
     * is given and what became of its rays only.
     */
    void run(Beam beam, ForwardPass pass);
}
