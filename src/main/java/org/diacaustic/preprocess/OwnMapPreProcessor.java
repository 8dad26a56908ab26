package org.diacaustic.preprocess;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.diacaustic.light.LightPoint;
import org.diacaustic.math.SampleStream;

/**
 * Rays at a lattice of points on the map of every transparent or mirroring object itself [Thesis 6.2, proposed there and not
 * built]. Nothing is aimed beside an object, and none needs a place in a plane before the light: the light may stand
 * among the objects, or in one.
 *
 * <p>A ray stands for the solid angle of its part of the surface, so it counts only if that is what it meets first: the light
 * that others stop is theirs. That is right on average for objects of any shape with bounds, and evenest for what its
 * own chart sees squarely: flat ones, and round ones about their middle. A light much closer to an object than that is large
 * makes uneven photons of it, strong where it is near; rays that are laid out around the light are better then.
 */
final class OwnMapPreProcessor implements PreProcessor {
    static final String NAME = "own-map";

    private static final int LINES_A_TASK = 4096;

    /** Lines through an object to find out how much of it the light sees. */
    private static final int LOOKS = 1024;

    /** Of an object's lines no more go in vain than this, for one that brings a ray. */
    private static final double LEAST_SEEN = 1.0 / 64;

    /** The part of the rays that is dealt out evenly. */
    private static final double LEAST_SHARE = 1.0 / 16;

    @Override
    public String name() {
        return NAME;
    }

    @Override
    public Optional<String> refusal(Beam beam) {
        return beam.specularObjects()
                .mapToObj(beam.scene()::object)
                .filter(object -> Beam.isEndless(object.shape()))
                .map(object -> "'" + object.name() + "' has no bounds")
                .findFirst();
    }

    @Override
    public List<EmissionChart> charts(Beam beam, LightPoint from) {
        return OwnCharts.of(beam, from).map(List::of).orElseGet(() -> beam.cubeCharts(from));
    }

    /** Objects without bounds have charts around the light. */
    @Override
    public Optional<String> cellRefusal(Beam beam) {
        return Optional.empty();
    }

    @Override
    public void run(Beam beam, ForwardPass pass) {
        SampleStream random = pass.random();
        SampleStream shifts = beam.settings().shiftsLattice() ? random : null;
        LightPoints points = new LightPoints(beam, random);
        List<Seen> maps = seen(beam);
        double flux = maps.stream().mapToDouble(Seen::flux).sum();
        while (points.next()) {
            for (Seen seen : maps) {
                // By flux, so that photons are about equal; but something for what seems to get none.
                double share =
                        flux > 0 ? (1 - LEAST_SHARE) * seen.flux / flux + LEAST_SHARE / maps.size() : 1.0 / maps.size();
                double lines = beam.rays() * share / points.count() / Math.max(LEAST_SEEN, seen.fraction);
                List<LineLattice> lattices =
                        seen.map.lattices(lines, beam.settings().latticeSize(), shifts);
                shoot(beam, pass, points, seen.map, lattices);
            }
        }
    }

    private static void shoot(Beam beam, ForwardPass pass, LightPoints points, OwnMap map, List<LineLattice> lattices) {
        double share = 1.0 / points.count();
        double s = points.s();
        double t = points.t();
        for (int k = 0; k < lattices.size(); k++) {
            int which = k;
            long lines = lattices.get(k).size();
            pass.shootTasks(ForwardPass.tasks(lines, LINES_A_TASK), (task, emitter) -> {
                SurfaceSight sight = new SurfaceSight(beam, map);
                LightPoint from = emitter.point(s, t);
                long first = (long) task * LINES_A_TASK;
                map.cross(lattices, which, first, Math.min(lines, first + LINES_A_TASK), (line, area) -> {
                    if (sight.aim(from, line.hit, area, emitter.ray())) {
                        emitter.shoot(share);
                    }
                });
            });
        }
    }

    private static List<Seen> seen(Beam beam) {
        List<Seen> all = new ArrayList<>();
        for (int number : beam.specularObjects().toArray()) {
            OwnMap.of(number, beam.scene().object(number)).ifPresent(map -> all.add(look(beam, map)));
        }
        return all;
    }

    /** Looks at an object from all over the light. */
    private static Seen look(Beam beam, OwnMap map) {
        SurfaceSight sight = new SurfaceSight(beam, map);
        LightRay ray = new LightRay();
        LightPoint from = new LightPoint();
        SampleStream random = new SampleStream();
        List<LineLattice> lattices = map.lattices(LOOKS, 0, random);
        double[] flux = new double[1];
        long[] count = new long[1];
        IntStream.range(0, lattices.size())
                .forEach(k -> map.cross(lattices, k, 0, lattices.get(k).size(), (line, area) -> {
                    beam.light().emitFrom(random.nextDouble(), random.nextDouble(), from);
                    if (sight.aim(from, line.hit, area, ray)) {
                        count[0]++;
                        flux[0] += sight.brightness() * ray.measure;
                    }
                }));
        long lines = lattices.stream().mapToLong(LineLattice::size).sum();
        return new Seen(map, (double) count[0] / lines, flux[0]);
    }

    /**
     * What the light sees of an object.
     *
     * @param fraction rays ÷ lines
     * @param flux about what it gets, in W
     */
    private record Seen(OwnMap map, double fraction, double flux) {}
}
