package org.diacaustic.preprocess;

import java.util.List;
import java.util.Optional;
import org.diacaustic.light.LightPoint;

/** A lattice of rays through a plane before the window [Thesis 4.6]. It needs the light to stand outside of what it lights. */
final class PlanarPreProcessor implements PreProcessor {
    static final String NAME = "planar";

    @Override
    public String name() {
        return NAME;
    }

    @Override
    public Optional<String> refusal(Beam beam) {
        LightPoint middle = new LightPoint();
        beam.light().emitFrom(0.5, 0.5, middle);
        return beam.planeRefusal(middle);
    }

    @Override
    public void run(Beam beam, ForwardPass pass) {
        CubePreProcessor.shoot(beam, pass, from -> charts(beam, from));
    }

    /** Of a lamp that stands outside, single points may still have no plane before the window: those have the cube. */
    @Override
    public List<EmissionChart> charts(Beam beam, LightPoint from) {
        return beam.planeRefusal(from).isPresent() ? beam.cubeCharts(from) : List.of(beam.planeChart(from));
    }
}
