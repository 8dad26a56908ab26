package org.diacaustic.preprocess;

/**
 * Independent random rays [Thesis 4.2]: uniform in the light space of the window. The thesis' were random vectors in a
 * cube, normalised, and so five times as dense at its corners as at the middle of its faces; those are there by name, with
 * their true density.
 */
final class RandomPreProcessor implements PreProcessor {
    static final String NAME = "random";

    @Override
    public String name() {
        return NAME;
    }

    @Override
    public void run(Beam beam, ForwardPass pass) {
        double share = 1.0 / beam.rays();
        pass.shootRays(beam.rays(), (number, emitter) -> {
            RandomRays.aim(beam, emitter.random(number), emitter);
            emitter.shoot(share);
        });
    }
}
