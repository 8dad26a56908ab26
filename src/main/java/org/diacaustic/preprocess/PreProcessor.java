package org.diacaustic.preprocess;

import java.util.List;
import java.util.Optional;
import org.diacaustic.light.LightPoint;

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
     * The parts of a point's light space that it lays its lattices on, which cells of a caustic mesh may stand on too; nothing
     * if it has no lattices.
     */
    default List<EmissionChart> charts(Beam beam, LightPoint from) {
        return List.of();
    }

    /** Why there can be no cells of a caustic mesh on its lattices for this beam, as {@link #refusal}. */
    default Optional<String> cellRefusal(Beam beam) {
        LightPoint middle = new LightPoint();
        beam.light().emitFrom(0.5, 0.5, middle);
        return charts(beam, middle).isEmpty()
                ? Optional.of("it sends no neighbouring rays, between which there could be cells of a caustic mesh")
                : refusal(beam);
    }

    /**
     * Chooses rays for one beam and has them followed. What it does must depend on the beam, the random numbers that it
     * is given and what became of its rays only.
     */
    void run(Beam beam, ForwardPass pass);
}
