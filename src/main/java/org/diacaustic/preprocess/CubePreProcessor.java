package org.diacaustic.preprocess;

import java.util.List;
import org.diacaustic.light.LightPoint;

/** Lattices of rays through the faces of a cube around the light [Thesis 4.7]. */
final class CubePreProcessor implements PreProcessor {
    static final String NAME = "cube";

    @Override
    public String name() {
        return NAME;
    }

    @Override
    public List<EmissionChart> charts(Beam beam, LightPoint from) {
        return beam.cubeCharts(from);
    }

    @Override
    public void run(Beam beam, ForwardPass pass) {
        shoot(beam, pass, beam::cubeCharts);
    }

    /** Sends the rays of a lattice on every chart. */
    static void shoot(Beam beam, ForwardPass pass, Lattices.Charting charting) {
        var all = Lattices.of(beam, beam.rays(), charting, pass.random());
        double pointShare = 1.0 / all.size();
        for (Lattices.PointLattices point : all) {
            for (Lattice lattice : point.lattices()) {
                double share = pointShare * lattice.share();
                pass.shootRays(lattice.size(), (i, emitter) -> {
                    emitter.point(point.s(), point.t());
                    lattice.aim(i, emitter.ray());
                    emitter.shoot(share);
                });
            }
        }
    }
}
