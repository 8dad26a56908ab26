package org.diacaustic.preprocess;

import org.diacaustic.light.Light;
import org.diacaustic.light.LightPoint;
import org.diacaustic.math.SampleStream;

/** Aims single random rays. */
final class RandomRays {
    private RandomRays() {}

    /** Aims a ray from a random point of the light into a random direction of the beam. */
    static void aim(Beam beam, SampleStream random, LightEmitter emitter) {
        LightPoint from = emitter.point(random.nextDouble(), random.nextDouble());
        boolean isCube =
                !beam.settings().usesUniformDirections() && beam.light().spread() == Light.Spread.FROM_POINT;
        if (isCube) {
            aimInCube(from, random, emitter.ray());
        } else {
            beam.uniformChart(from).aim(random.nextDouble(), random.nextDouble(), emitter.ray());
        }
    }

    /** A random vector of the cube [−1, 1]³, normalised [THESIS-NOTES identity 8]. */
    private static void aimInCube(LightPoint from, SampleStream random, LightRay ray) {
        double x = 2 * random.nextDouble() - 1;
        double y = 2 * random.nextDouble() - 1;
        double z = 2 * random.nextDouble() - 1;
        ray.setOrigin(from.x, from.y, from.z);
        ray.setDirection(x, y, z);
        double largest =
                Math.max(Math.abs(ray.directionX), Math.max(Math.abs(ray.directionY), Math.abs(ray.directionZ)));
        // A direction's density is the volume of the cube along it, ∫r²dr = (1 / largest)³ / 3, over the whole, 8.
        ray.measure = 24 * largest * largest * largest;
    }
}
