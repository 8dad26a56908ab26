package org.diacaustic.study;

import org.diacaustic.light.LightPoint;
import org.diacaustic.math.SampleStream;
import org.diacaustic.preprocess.Beam;
import org.diacaustic.preprocess.ForwardPass;
import org.diacaustic.preprocess.PreProcessor;

/** Random rays that carry 5 % too much, which a study must not let pass. Found as users' own pre-processors are. */
public final class TooBright implements PreProcessor {
    static final double FACTOR = 1.05;

    @Override
    public String name() {
        return "too-bright";
    }

    @Override
    public void run(Beam beam, ForwardPass pass) {
        double share = FACTOR / beam.rays();
        pass.shootRays(beam.rays(), (number, emitter) -> {
            SampleStream random = emitter.random(number);
            LightPoint from = emitter.point(random.nextDouble(), random.nextDouble());
            beam.uniformChart(from).aim(random.nextDouble(), random.nextDouble(), emitter.ray());
            emitter.shoot(share);
        });
    }
}
