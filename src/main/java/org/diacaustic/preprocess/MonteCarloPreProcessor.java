package org.diacaustic.preprocess;

import org.diacaustic.light.LightPoint;
import org.diacaustic.math.SampleStream;

/**
 * Random rays that look around, and batches of rays about those that found something [Thesis 4.2]. Weighted, the rays that
 * look only decide where batches go, and every ray of a batch is weighed by the density of all that could have chosen it
 * [Veach and Guibas 1995]. Unweighted, as in the thesis, all are stored alike: where batches overlap it is too bright.
 */
final class MonteCarloPreProcessor implements PreProcessor {
    static final String NAME = "monte-carlo";

    /** Parts of the rays, out of 8: those that look, and those that are spread evenly so that nothing is left out. */
    private static final int LOOKING = 1;

    private static final int EVEN = 2;
    private static final int BASE_RAYS_A_TASK = 1024;

    /** Rays that look, at most: an array has a place for each. */
    private static final long MOST_LOOKING = 1 << 29;

    @Override
    public String name() {
        return NAME;
    }

    @Override
    public void run(Beam beam, ForwardPass pass) {
        if (pass.isWeighted()) {
            runWeighted(beam, pass);
        } else {
            runAsTheThesis(beam, pass);
        }
    }

    private static void runWeighted(Beam beam, ForwardPass pass) {
        int base = looking(beam);
        double[] places = new double[2 * base];
        boolean[] found = new boolean[base];
        pass.shootRays(base, (number, emitter) -> {
            SampleStream random = emitter.random(number);
            LightPoint from = emitter.point(random.nextDouble(), random.nextDouble());
            int i = (int) number;
            places[2 * i] = random.nextDouble();
            places[2 * i + 1] = random.nextDouble();
            beam.uniformChart(from).aim(places[2 * i], places[2 * i + 1], emitter.ray());
            found[i] = emitter.probe() > 0;
        });
        double half = spread(beam, base) / Math.sqrt(measure(beam));
        BatchDensity density = BatchDensity.around(places, found, Math.min(0.5, half));
        long even = Math.max(1, beam.rays() * EVEN / 8);
        long batch = density.count() == 0
                ? 0
                : orElse(beam.settings().batchRays(), Math.max(0, beam.rays() - base - even) / density.count());
        pass.shootRays(even + batch * density.count(), (number, emitter) -> {
            SampleStream random = emitter.random(number);
            LightPoint from = emitter.point(random.nextDouble(), random.nextDouble());
            double p = random.nextDouble();
            double q = random.nextDouble();
            if (number >= even) {
                int centre = (int) ((number - even) / batch);
                p = density.spreadP(centre, p);
                q = density.spreadQ(centre, q);
            }
            beam.uniformChart(from).aim(p, q, emitter.ray());
            emitter.shoot(1 / (even + batch * density.at(p, q)));
        });
    }

    private static int looking(Beam beam) {
        long base = Math.max(1, orElse(beam.settings().baseRays(), beam.rays() * LOOKING / 8));
        if (base > MOST_LOOKING) {
            throw new ForwardPlanException("preprocessor '" + NAME + "' can look around with " + MOST_LOOKING
                    + " rays at most, but is to do with " + base + "; give fewer rays or base-rays");
        }
        return (int) base;
    }

    /** How far the rays of a batch lie from their base ray; if that is not given, as far as the next base rays are. */
    private static double spread(Beam beam, long base) {
        double given = beam.settings().batchSpread();
        return given > 0 ? given : Math.sqrt(measure(beam) / base);
    }

    /** The solid angle, or the area, that the window has for the middle of the light. */
    private static double measure(Beam beam) {
        LightPoint middle = new LightPoint();
        beam.light().emitFrom(0.5, 0.5, middle);
        LightRay ray = new LightRay();
        beam.uniformChart(middle).aim(0.5, 0.5, ray);
        return ray.measure;
    }

    /** Batches follow at once on the base ray that was stored: later base rays may find their areas taken. */
    private static void runAsTheThesis(Beam beam, ForwardPass pass) {
        long base = orElse(beam.settings().baseRays(), beam.rays());
        long batch = orElse(beam.settings().batchRays(), 1000);
        double spread = spread(beam, base);
        pass.shootTasks(ForwardPass.tasks(base, BASE_RAYS_A_TASK), (task, emitter) -> {
            long end = Math.min(base, (task + 1L) * BASE_RAYS_A_TASK);
            for (long number = (long) task * BASE_RAYS_A_TASK; number < end && !emitter.isStopped(); number++) {
                SampleStream random = emitter.random(number);
                RandomRays.aim(beam, random, emitter);
                double x = emitter.ray().directionX;
                double y = emitter.ray().directionY;
                double z = emitter.ray().directionZ;
                if (emitter.shoot(1) > 0) {
                    for (long i = 0; i < batch && !emitter.isStopped(); i++) {
                        emitter.ray()
                                .setDirection(
                                        x + spread * (2 * random.nextDouble() - 1),
                                        y + spread * (2 * random.nextDouble() - 1),
                                        z + spread * (2 * random.nextDouble() - 1));
                        emitter.shoot(1);
                    }
                }
            }
        });
    }

    private static long orElse(long given, long otherwise) {
        return given > 0 ? given : otherwise;
    }
}
