package org.diacaustic.study;

import java.util.Arrays;
import java.util.function.IntConsumer;
import org.diacaustic.image.LinearImage;
import org.diacaustic.map.PhotonCapacityException;
import org.diacaustic.map.PhotonStore;
import org.diacaustic.math.Rgb;
import org.diacaustic.parallel.Workers;
import org.diacaustic.preprocess.ForwardPass;
import org.diacaustic.preprocess.ForwardPlan;
import org.diacaustic.preprocess.ForwardPlanException;
import org.diacaustic.render.PlanException;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.render.ResourceLimitException;
import org.diacaustic.scene.Scene;

/**
 * Light that reaches diffuse surfaces over specular ones, traced from the lamps straight into the pixels of a pinhole camera:
 * the mean over each pixel, without map, kernel or footprint, so that it can judge all of them. It holds what the eye sees
 * directly; what it sees mirrored, through glass, or lit without any detour is not in it. The numbers of the batches say
 * everything: the picture is the same on any number of threads.
 */
final class LightTracedPicture {
    private static final int PHOTONS_A_TASK = 4096;
    private static final int PHOTONS_A_ROUND = 1 << 18;

    private final Scene scene;
    private final RenderPlan plan;
    private final ForwardPlan forward;
    private final Workers workers;
    private final PinholeView view;
    private final PixelBatches batches;
    private final int strips;
    private final IntConsumer turnTo;
    private final int[] pixels = new int[PHOTONS_A_ROUND];
    private final double[] radiances = new double[3 * PHOTONS_A_ROUND];
    private long lightRays;
    private long photonsSeen;
    private long tests;
    private double traceSeconds;

    /**
     * @param plan whose forward pass is run again and again; its rays must carry their flux
     * @param strips passes of a batch, which are the light only together
     * @param turnTo is told the number of the strip before each pass
     * @throws IllegalArgumentException if the camera has a lens, or there is no light to be traced
     */
    LightTracedPicture(RenderPlan plan, Workers workers, int strips, IntConsumer turnTo) {
        this.strips = strips;
        this.turnTo = turnTo;
        this.plan = plan;
        this.scene = plan.scene();
        this.forward = plan.forward()
                .orElseThrow(() -> new IllegalArgumentException(
                        "no light reaches anything after being refracted or mirrored, so there is none to trace"));
        if (!forward.isWeighted()) {
            throw new IllegalArgumentException("light rays that all count alike make no picture without a map");
        }
        this.workers = workers;
        this.view = new PinholeView(scene.camera());
        this.batches = new PixelBatches(scene.camera().width(), scene.camera().height());
    }

    /**
     * Runs the forward passes of a batch, and adds what they bring.
     *
     * @throws PlanException if the pre-processor cannot serve the scene
     * @throws ResourceLimitException if there are more photons than fit in memory
     */
    void add(int batch) {
        for (int strip = 0; strip < strips; strip++) {
            turnTo.accept(strip);
            Clock clock = new Clock();
            ForwardPass traced = trace(batch * strips + strip);
            traceSeconds += clock.wallSeconds();
            tests += traced.counters().intersectionTests();
            PhotonStore photons = traced.photons();
            for (int start = 0; start < photons.size(); start += PHOTONS_A_ROUND) {
                put(photons, start, Math.min(PHOTONS_A_ROUND, photons.size() - start));
            }
            lightRays += traced.counters().lightRays();
        }
        batches.next();
    }

    private ForwardPass trace(int pass) {
        try {
            return new ForwardPass(forward, pass, workers).run();
        } catch (ForwardPlanException refused) {
            throw new PlanException(refused.getMessage());
        } catch (PhotonCapacityException full) {
            throw new ResourceLimitException(full.getMessage() + ": give Java more memory (-Xmx)");
        }
    }

    /** Finds the photons' pixels on all threads, and then adds them up in the order of the photons. */
    private void put(PhotonStore photons, int start, int count) {
        int tasks = (count + PHOTONS_A_TASK - 1) / PHOTONS_A_TASK;
        long[] testsOfTasks = new long[tasks];
        workers.run(tasks, () -> {
            PhotonSplatter splatter = new PhotonSplatter(scene, plan.settings(), forward, view);
            return task -> {
                int end = Math.min(count, (task + 1) * PHOTONS_A_TASK);
                for (int i = task * PHOTONS_A_TASK; i < end; i++) {
                    pixels[i] = splatter.put(photons, start + i);
                    note(i, splatter.radiance);
                }
                testsOfTasks[task] = splatter.takeTests();
            };
        });
        tests += Arrays.stream(testsOfTasks).sum();
        for (int i = 0; i < count; i++) {
            if (pixels[i] >= 0) {
                photonsSeen++;
                batches.add(
                        pixels[i],
                        radiances[3 * i] / strips,
                        radiances[3 * i + 1] / strips,
                        radiances[3 * i + 2] / strips);
            }
        }
    }

    private void note(int i, Rgb radiance) {
        radiances[3 * i] = radiance.red;
        radiances[3 * i + 1] = radiance.green;
        radiances[3 * i + 2] = radiance.blue;
    }

    /** The light, as the mean of all batches. */
    LinearImage picture() {
        return batches.mean();
    }

    /** The batches that were added: independent pictures. */
    PixelBatches batches() {
        return batches;
    }

    /** Light rays followed so far, with all that became of them. */
    long lightRays() {
        return lightRays;
    }

    /** Tests of a ray against an object or a volume so far, of light rays and of the eye's. */
    long tests() {
        return tests;
    }

    /** Seconds by the clock that went into following light so far; the rest went into the pixels. */
    double traceSeconds() {
        return traceSeconds;
    }

    /** Photons seen so far. */
    long photonsSeen() {
        return photonsSeen;
    }
}
