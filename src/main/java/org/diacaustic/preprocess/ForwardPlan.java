package org.diacaustic.preprocess;

import java.util.List;
import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.transport.PathRules;

/**
 * A forward pass resolved into numbers: which beams, what each ray may do, how much may be stored. Immutable.
 *
 * @param index the scene
 * @param rules how light is followed
 * @param rouletteThroughput light that carries a smaller fraction of its ray's flux is followed by chance; 0: never
 * @param preProcessor chooses the rays
 * @param beams one for each light and window
 * @param isWeighted whether rays carry flux; otherwise each carries as much as any other [Thesis 4.5]
 * @param seed of all random choices
 * @param origin the middle of what has bounds: photons are placed relative to it
 * @param extent the radius of a ball about the origin that holds it, positive
 * @param powerUnit about the power of a photon, in W
 * @param capacity the most photons that may be stored
 * @param map what keeps the light, chosen
 * @param estimator how it is read, chosen
 * @param passes how many independent passes are averaged
 * @param maps the numbers of map and estimator, as far as they are given
 */
public record ForwardPlan(
        SceneIndex index,
        PathRules rules,
        double rouletteThroughput,
        PreProcessor preProcessor,
        List<Beam> beams,
        boolean isWeighted,
        long seed,
        Vector3 origin,
        double extent,
        double powerUnit,
        int capacity,
        MapName map,
        EstimatorName estimator,
        int passes,
        MapSettings maps) {

    /** The unit that places of photons and cells are kept in: about the extent. */
    double lengthUnit() {
        return unit(extent);
    }

    /** The same, or the nearest that can be divided by. */
    static double unit(double size) {
        return Arithmetic.clamp(size, Double.MIN_NORMAL, 1 / Double.MIN_NORMAL);
    }

    /** The rays that are to be chosen in a pass. */
    public long rays() {
        return beams.stream().mapToLong(Beam::rays).sum();
    }

    /** Whether rays depend on what others before them stored, so that they must follow one another on one thread. */
    boolean isSequential() {
        return maps.initialHits() > 0;
    }
}
