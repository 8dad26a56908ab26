package org.diacaustic.trial;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.apache.commons.math3.stat.correlation.PearsonsCorrelation;
import org.diacaustic.light.PointLight;
import org.diacaustic.map.PhotonStore;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.preprocess.ForwardPass;
import org.diacaustic.preprocess.ForwardPlan;
import org.diacaustic.scene.Settings;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Whether rays of different lights, passes and threads have random numbers of their own. */
final class StreamTrials {
    private static final int LIGHTS = 3;
    private static final int PASSES = 2;
    private static final int THREADS = 8;
    private static final int RAYS_A_LIGHT = 1 << 15;

    /** Threads take as many rays at a time. */
    private static final int RAYS_A_TASK = 4096;

    private StreamTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "stream_independence",
                "Three like lamps at one place send 32768 random rays each through a sheet of index 1, in two passes on 8"
                        + " threads: no two photons may lie at the same place, and one thread must store the same. The x, y and z of"
                        + " directions of all lights and passes are correlated ray by ray, and with themselves one task of 4096"
                        + " rays later: |r| < 4/sqrt(N), N the number of pairs.",
                StreamTrials::run);
    }

    private static void run(NumericCase asked, Checks checks) {
        long seed = asked.inputs().integer("seed");
        Settings settings = LitFloor.within(1, seed);
        RecordingLight[] lights = new RecordingLight[LIGHTS];
        for (int i = 0; i < LIGHTS; i++) {
            lights[i] = new RecordingLight(new PointLight(new Vector3(0, 2, 0), Color.WHITE));
        }
        ForwardPlan plan = LightRun.plan(
                LitFloor.under(1, 1, 4, lights.clone()), settings, "random", (long) LIGHTS * RAYS_A_LIGHT);
        Set<List<Double>> places = new HashSet<>();
        long stored = 0;
        boolean isSame = true;
        List<Directions> directions = new ArrayList<>();
        for (int pass = 0; pass < PASSES; pass++) {
            PhotonStore photons =
                    new ForwardPass(plan, pass, new Workers(THREADS)).run().photons();
            stored += photons.size();
            for (int i = 0; i < photons.size(); i++) {
                places.add(place(photons, i));
            }
            for (RecordingLight light : lights) {
                directions.add(new Directions(light));
            }
            isSame &= isSame(
                    photons, new ForwardPass(plan, pass, new Workers(1)).run().photons());
            for (RecordingLight light : lights) {
                light.tell((point, dx, dy, dz, intensity) -> {});
            }
        }
        checks.same(
                "duplicate_photon_positions",
                asked.expected().integer("duplicate_photon_positions"),
                stored - places.size());
        checks.holds("one thread stores the same", isSame);
        correlate(directions, checks);
    }

    private static List<Double> place(PhotonStore photons, int i) {
        SurfacePoint at = new SurfacePoint();
        photons.position(i, at);
        return List.of(at.x, at.y, at.z);
    }

    private static boolean isSame(PhotonStore one, PhotonStore other) {
        boolean isSame = one.size() == other.size();
        for (int i = 0; isSame && i < one.size(); i++) {
            isSame = place(one, i).equals(place(other, i));
        }
        return isSame;
    }

    private static void correlate(List<Directions> directions, Checks checks) {
        double largest = 0;
        double largestLater = 0;
        PearsonsCorrelation pearson = new PearsonsCorrelation();
        for (int a = 0; a < directions.size(); a++) {
            for (int axis = 0; axis < 3; axis++) {
                double[] first = directions.get(a).of(axis, 0, RAYS_A_LIGHT);
                for (int b = 0; b < a; b++) {
                    double[] second = directions.get(b).of(axis, 0, RAYS_A_LIGHT);
                    largest = Math.max(largest, Math.abs(pearson.correlation(first, second)));
                }
                double[] now = directions.get(a).of(axis, 0, RAYS_A_LIGHT - RAYS_A_TASK);
                double[] later = directions.get(a).of(axis, RAYS_A_TASK, RAYS_A_LIGHT);
                largestLater = Math.max(largestLater, Math.abs(pearson.correlation(now, later)));
            }
        }
        checks.atMost("largest |r| of lights and passes", 4 / Math.sqrt(RAYS_A_LIGHT), largest);
        checks.atMost("largest |r| of tasks", 4 / Math.sqrt(RAYS_A_LIGHT - RAYS_A_TASK), largestLater);
    }

    /** The directions that a light sends rays into from now on. */
    private static final class Directions {
        private final List<double[]> all = new ArrayList<>();

        Directions(RecordingLight light) {
            light.tell((point, dx, dy, dz, intensity) -> all.add(new double[] {dx, dy, dz}));
        }

        double[] of(int axis, int start, int end) {
            return all.subList(start, end).stream().mapToDouble(d -> d[axis]).toArray();
        }
    }
}
