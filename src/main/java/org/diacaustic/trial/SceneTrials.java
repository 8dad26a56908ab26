package org.diacaustic.trial;

import java.util.List;
import org.apache.commons.math3.stat.StatUtils;
import org.diacaustic.image.LinearImage;
import org.diacaustic.light.Falloff;
import org.diacaustic.map.IlluminationMap;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.diacaustic.render.Rendering;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.SceneObject;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Hit;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Whole scenes, scaled and moved. */
final class SceneTrials {
    /** Scenes of chance, each rendered in another way, so that most of what there is has a part. */
    private static final List<Long> SEEDS = List.of(1L, 2L, 3L, 4L, 5L, 6L, 7L, 8L, 9L, 10L, 11L, 12L);

    private static final int PIXELS = 60;
    private static final long LIGHT_RAYS = 4000;

    /** At flatter angles a hit is off by more than what it is off across the surface. */
    private static final double LEAST_COSINE = 0.17;

    /** One with caustics of photons on the floor. */
    private static final long PHOTON_SCENE = 7;

    private static final int MAPS = 12;

    private SceneTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "metamorphic_scale",
                "Renders " + SEEDS.size()
                        + " scenes of chance, in six ways to trace light forward, with every length and the light's"
                        + " power scaled. A power of two must change no bit, also without falloff of light; any other"
                        + " factor no pixel by more than the tolerance, but for the share of pixels that the case allows. Then photons are"
                        + " followed without roulette, which takes its chances from the digits of a ray.",
                SceneTrials::scale);
        operations.add(
                "metamorphic_translate",
                "Renders the same scenes moved. Hits at less than 80 degrees must be within the tolerance of where they were; pixels too, where the light"
                        + " of all eight neighbours is within a tenth of theirs; the mean irradiance from photons at 25 places of the floor must be"
                        + " that of the scene at the origin, within 4 sigma of the difference of two means over " + MAPS
                        + " maps each.",
                SceneTrials::translate);
    }

    private static void scale(NumericCase asked, Checks checks) {
        if (asked.inputs().has("log2_scale")) {
            scaleByPowerOfTwo(StrictMath.pow(2, asked.inputs().number("log2_scale")), checks);
        } else {
            scale(asked.inputs().number("scale"), asked.tolerance().number("max_pixel_rel", 1e-9), checks);
        }
    }

    private static void scaleByPowerOfTwo(double scale, Checks checks) {
        int off = 0;
        int withoutFalloff = 0;
        double hits = 0;
        long stored = 0;
        for (long seed : SEEDS) {
            RandomScene random = random(seed);
            Settings settings = Way.of(seed).settings(LIGHT_RAYS, seed);
            Scene home = random.build(Placing.HOME, new Falloff.InverseSquare(), 1);
            Scene scaled = random.build(Placing.scaled(scale), new Falloff.InverseSquare(), scale * scale);
            Rendering before = Pictures.render(home, settings);
            Rendering after = Pictures.render(scaled, settings);
            off += Pictures.different(before.image(), after.image());
            hits = Math.max(hits, farthestOff(home, scaled, Placing.scaled(scale)));
            stored += Math.abs(before.forward().counters().stored()
                    - after.forward().counters().stored());
            withoutFalloff += Pictures.different(
                    Pictures.render(random.build(Placing.HOME, new Falloff.None(), 1), settings)
                            .image(),
                    Pictures.render(random.build(Placing.scaled(scale), new Falloff.None(), 1), settings)
                            .image());
        }
        checks.same("pixels that differ", 0, off);
        checks.same("pixels that differ, lights without falloff", 0, withoutFalloff);
        checks.number("largest change of a hit, scaled back", 0, hits, 0);
        checks.same("change of stored photons", 0L, stored);
    }

    private static void scale(double scale, double largest, Checks checks) {
        int off = 0;
        boolean finite = true;
        for (long seed : SEEDS) {
            RandomScene random = random(seed);
            Settings settings = withoutRoulette(Way.of(seed).settings(LIGHT_RAYS, seed));
            LinearImage before = Pictures.render(random.build(Placing.HOME, new Falloff.InverseSquare(), 1), settings)
                    .image();
            LinearImage after = Pictures.render(
                            random.build(Placing.scaled(scale), new Falloff.InverseSquare(), scale * scale), settings)
                    .image();
            off += Pictures.different(before, after, largest);
            finite &= Pictures.isFinite(after);
        }
        checks.holds("finite", finite);
        checks.atMost("share of pixels that differ", 1e-4, (double) off / (SEEDS.size() * PIXELS * PIXELS));
    }

    /** Meshes know no roulette. */
    private static Settings withoutRoulette(Settings settings) {
        return settings.maps().map() == MapName.CAUSTIC_MESH
                ? settings
                : settings.toBuilder().minimumThroughput(0).build();
    }

    private static void translate(NumericCase asked, Checks checks) {
        Placing moved = Placing.moved(asked.inputs().number("offset"));
        double hits = 0;
        int off = 0;
        for (long seed : SEEDS) {
            Scene home = random(seed).build(Placing.HOME, new Falloff.InverseSquare(), 1);
            Scene there = random(seed).build(moved, new Falloff.InverseSquare(), 1);
            hits = Math.max(hits, farthestOff(home, there, moved));
            off += Pictures.differentInside(
                    Pictures.render(home, Way.NONE.settings(0, 1)).image(),
                    Pictures.render(there, Way.NONE.settings(0, 1)).image(),
                    asked.tolerance().number("interior_pixels_rel", 1e-6));
        }
        checks.number("farthest hit", 0, hits, asked.tolerance().number("hit_abs"));
        checks.same("interior pixels that differ", 0, off);
        compareMaps(moved, checks);
    }

    private static void compareMaps(Placing moved, Checks checks) {
        double[] home = new double[MAPS];
        double[] there = new double[MAPS];
        for (int map = 0; map < MAPS; map++) {
            home[map] = irradiance(Placing.HOME, map);
            there[map] = irradiance(moved, map);
        }
        double mean = StatUtils.mean(home);
        double error = Math.sqrt((StatUtils.variance(home) + StatUtils.variance(there)) / MAPS);
        checks.statistic("photon_estimate_ratio", 1, StatUtils.mean(there) / mean, error / mean, 4);
    }

    private static double irradiance(Placing placing, long seed) {
        Way way = Way.of(PHOTON_SCENE);
        IlluminationMap.Lookup lookup = LightRun.of(
                        random(PHOTON_SCENE).build(placing, new Falloff.InverseSquare(), 1),
                        way.settings(LIGHT_RAYS, seed),
                        way.preProcessor(),
                        LIGHT_RAYS)
                .lookup();
        double sum = 0;
        for (int i = 0; i < 25; i++) {
            Vector3 at = placing.point(i % 5 - 2, 0, i / 5 - 2);
            sum += LightRun.irradiance(lookup, 0, at.x(), at.y(), at.z());
        }
        return sum / 25;
    }

    private static RandomScene random(long seed) {
        return new RandomScene(seed, PIXELS, !Way.of(seed).needsEnds());
    }

    /**
     * How far any coordinate of a hit of an eye ray is from where it should be, brought back home. Rays that meet another
     * object, by an edge, are left out, but not more than one in a thousand: then a hit counts as lost.
     */
    private static double farthestOff(Scene home, Scene placed, Placing placing) {
        SceneIndex atHome = SceneIndex.of(home.objects(), false);
        SceneIndex there = SceneIndex.of(placed.objects(), false);
        Ray before = new Ray();
        Ray after = new Ray();
        Hit hit = new Hit();
        double farthest = 0;
        int lost = 0;
        for (int i = 0; i < PIXELS * PIXELS; i++) {
            int row = i / PIXELS;
            home.camera().aim(i % PIXELS + 0.5, row + 0.5, 0, 0, before);
            placed.camera().aim(i % PIXELS + 0.5, row + 0.5, 0, 0, after);
            int object = atHome.nearest(before, SceneIndex.NONE, Ray.FREE);
            int found = there.nearest(after, SceneIndex.NONE, Ray.FREE);
            if (object != found) {
                lost++;
            } else if (object != SceneIndex.NONE) {
                complete(atHome.object(object), before, hit);
                Vector3 from = new Vector3(hit.x, hit.y, hit.z);
                double cosine = hit.normalX * before.directionX
                        + hit.normalY * before.directionY
                        + hit.normalZ * before.directionZ;
                complete(there.object(found), after, hit);
                Vector3 off = new Vector3(hit.x, hit.y, hit.z)
                        .minus(placing.offset())
                        .times(1 / placing.scale())
                        .minus(from);
                double largest = Math.max(Math.abs(off.x()), Math.max(Math.abs(off.y()), Math.abs(off.z())));
                farthest = Math.abs(cosine) > LEAST_COSINE ? Math.max(farthest, largest) : farthest;
            }
        }
        return lost > PIXELS * PIXELS / 1000 ? Double.POSITIVE_INFINITY : farthest;
    }

    private static void complete(SceneObject object, Ray ray, Hit hit) {
        hit.take(ray);
        object.shape().complete(ray, hit);
    }
}
