package org.diacaustic.preprocess;

import java.util.List;
import org.diacaustic.light.LightPoint;

/**
 * A coarse lattice on the faces of a cube around the light, made finer where its rays are stored [Thesis 4.7.1]. Weighted, a
 * cell's ray stands for the cell, so that finer cells are not more light; unweighted, as in the thesis, every ray counts
 * alike.
 */
final class AdaptivePreProcessor implements PreProcessor {
    static final String NAME = "adaptive";

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
        boolean isSized = beam.settings().latticeSize() > 0;
        long firstLevel = isSized ? 0 : Math.max(16, beam.rays() / 16);
        List<Lattices.PointLattices> all = Lattices.of(beam, firstLevel, beam::cubeCharts, pass.random());
        if (!pass.isWeighted()) {
            new CornerRefinement(beam, pass).run(all);
            return;
        }
        for (Lattices.PointLattices point : all) {
            new CellRefinement(beam, pass, point, 1.0 / all.size()).run(beam.rays() / all.size());
        }
    }
}
