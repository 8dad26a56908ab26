package org.diacaustic.map;

import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;

/**
 * Puts 20 million photons and their tree into the memory that the virtual machine is given, which may be 1 GiB:
 * {@code java -Xmx1g -cp target/benchmarks.jar org.diacaustic.map.LargeStore [photons] [threads]}.
 */
public final class LargeStore {
    private static final int SLICE = 10_000;

    private LargeStore() {}

    public static void main(String[] arguments) {
        int size = arguments.length > 0 ? Integer.parseInt(arguments[0]) : 20_000_000;
        int threads = arguments.length > 1 ? Integer.parseInt(arguments[1]) : 2;
        long start = System.nanoTime();
        PhotonStore store = fill(size, new Workers(threads));
        long stored = System.nanoTime();
        PhotonTree tree = PhotonTree.movedFrom(store, new Workers(threads));
        long built = System.nanoTime();
        IlluminationMap.Lookup lookup = PhotonMap.over(
                        tree,
                        new Estimator.Nearest(50, Double.POSITIVE_INFINITY, Kernel.CONSTANT),
                        PhotonFilter.TWO_SIDED_NORMAL)
                .lookup();
        Rgb irradiance = new Rgb();
        SurfacePoint[] points = CausticPhotons.queries(100_000, false);
        for (SurfacePoint point : points) {
            lookup.irradiance(point, irradiance);
        }
        long asked = System.nanoTime();
        System.out.printf(
                "%d photons: stored in %.1f s, arranged in %.1f s, %d gathers in %.1f s; %.1f bytes a photon, heap of %d MiB%n",
                tree.size(),
                (stored - start) * 1e-9,
                (built - stored) * 1e-9,
                points.length,
                (asked - built) * 1e-9,
                (double) tree.bytes() / tree.size(),
                Runtime.getRuntime().maxMemory() >> 20);
    }

    /** All slices are filled before the first is appended, which is the most that a pass can need. */
    private static PhotonStore fill(int size, Workers workers) {
        PhotonStore store = new PhotonStore(new Vector3(0, -1, 0), 1, size);
        int tasks = (size + SLICE - 1) / SLICE;
        PhotonSlice[] slices = new PhotonSlice[tasks];
        workers.run(tasks, () -> {
            CausticPhotons photons = new CausticPhotons();
            return task -> {
                slices[task] = store.slice();
                photons.add(task, Math.min(SLICE, size - task * SLICE), slices[task]);
            };
        });
        for (PhotonSlice slice : slices) {
            store.append(slice);
        }
        return store;
    }
}
