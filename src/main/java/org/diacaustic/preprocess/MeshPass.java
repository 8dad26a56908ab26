package org.diacaustic.preprocess;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleConsumer;
import org.diacaustic.map.CellSlice;
import org.diacaustic.map.CellStore;
import org.diacaustic.map.LightPaths;
import org.diacaustic.parallel.Workers;

/**
 * A forward pass that keeps beams of light between neighbouring rays as cells, for a caustic mesh: the cells, and those of a
 * mesh half as fine of the same rays. What it makes does not depend on the number of threads.
 */
public final class MeshPass {
    /** Base cells along the side of a patch, even. */
    private static final int PATCH = 32;

    private static final int PATCHES_A_ROUND = 512;

    private final ForwardPlan plan;
    private final int pass;
    private final Workers workers;
    private final DoubleConsumer progress;
    private CellStore cells;
    private final CellStore largeCells;
    private List<MeshLattice> lattices = List.of();
    private final EnergyLedger ledger = new EnergyLedger();
    private final ForwardCounters counters = new ForwardCounters();

    /**
     * @param pass the number of the pass: passes are independent of each other
     * @param workers who do the work; if they are stopped, what was done by then is there
     * @param progress hears about which part of the pass is done, 0 to 1, from several threads
     */
    public MeshPass(ForwardPlan plan, int pass, Workers workers, DoubleConsumer progress) {
        this.plan = plan;
        this.pass = pass;
        this.workers = workers;
        this.progress = progress;
        this.cells = new CellStore(plan.origin(), plan.lengthUnit(), plan.powerUnit(), plan.capacity());
        this.largeCells = new CellStore(plan.origin(), plan.lengthUnit(), plan.powerUnit(), plan.capacity());
    }

    /**
     * Has the pass keep with each cell where its light comes from, which takes twice the memory: the mesh can then be asked
     * about single points exactly. To be called before the pass is run.
     *
     * <pre>{@code
     * MeshPass pass = new MeshPass(plan, 0, workers, progress).keepingSeeds().run();
     * CausticMesh mesh = CausticMesh.movedFrom(pass.cells(), workers);
     * FootprintLookup lookup = mesh.lookup(pass.lightPaths());
     * lookup.irradiance(point, irradiance);
     * }</pre>
     */
    public MeshPass keepingSeeds() {
        cells = CellStore.keepingSeeds(plan.origin(), plan.lengthUnit(), plan.powerUnit(), plan.capacity());
        return this;
    }

    /** Runs the pass, once. */
    public MeshPass run() {
        lattices = new MeshSizing(plan, pass).lattices(workers, counters);
        List<LatticePatch> patches = new ArrayList<>();
        for (int chart = 0; chart < lattices.size(); chart++) {
            addPatches(chart, patches);
        }
        if (plan.rays() > plan.capacity()) {
            requireRoom(patches);
        }
        AtomicInteger done = new AtomicInteger();
        for (int first = 0; first < patches.size() && !workers.stop().isSet(); first += PATCHES_A_ROUND) {
            makeRound(
                    patches.subList(first, Math.min(patches.size(), first + PATCHES_A_ROUND)),
                    first,
                    () -> progress.accept((double) done.incrementAndGet() / patches.size()));
        }
        counters.cells += cells.size();
        counters.nonFinite += cells.rejectedCount();
        return this;
    }

    private void addPatches(int chart, List<LatticePatch> patches) {
        MeshLattice lattice = lattices.get(chart);
        for (int row = 0; row < lattice.rows(); row += PATCH) {
            for (int column = 0; column < lattice.columns(); column += PATCH) {
                patches.add(new LatticePatch(
                        lattice,
                        chart,
                        column,
                        row,
                        Math.min(PATCH, lattice.columns() - column),
                        Math.min(PATCH, lattice.rows() - row)));
            }
        }
    }

    private void requireRoom(List<LatticePatch> patches) {
        CellStore tried = new CellStore(plan.origin(), plan.lengthUnit(), plan.powerUnit(), plan.capacity());
        StoreForecast.requireRoom("cells", plan.capacity(), 0, patches.size(), workers, () -> {
            MeshPatch maker = new MeshPatch(new LeafTracer(plan, workers.stop()));
            return task -> {
                CellSlice slice = tried.slice();
                maker.make(
                        patches.get(task),
                        streams(task),
                        slice,
                        tried.slice(),
                        new EnergyLedger(),
                        new ForwardCounters());
                return slice.size();
            };
        });
    }

    private void makeRound(List<LatticePatch> patches, int firstNumber, Runnable done) {
        int count = patches.size();
        CellSlice[] slices = new CellSlice[count];
        CellSlice[] largeSlices = new CellSlice[count];
        EnergyLedger[] ledgers = new EnergyLedger[count];
        ForwardCounters[] counts = new ForwardCounters[count];
        workers.run(count, () -> {
            MeshPatch maker = new MeshPatch(new LeafTracer(plan, workers.stop()));
            return task -> {
                slices[task] = cells.slice();
                largeSlices[task] = largeCells.slice();
                ledgers[task] = new EnergyLedger();
                counts[task] = new ForwardCounters();
                maker.make(
                        patches.get(task),
                        streams(firstNumber + task),
                        slices[task],
                        largeSlices[task],
                        ledgers[task],
                        counts[task]);
                done.run();
            };
        });
        Arrays.stream(slices).filter(slice -> slice != null).forEach(cells::append);
        Arrays.stream(largeSlices).filter(slice -> slice != null).forEach(largeCells::append);
        Arrays.stream(ledgers).filter(part -> part != null).forEach(ledger::add);
        Arrays.stream(counts).filter(part -> part != null).forEach(counters::add);
    }

    private long streams(int patch) {
        // Far apart for any numbers of passes and patches.
        return plan.seed() + ((pass + 1L) * 0x9E3779B97F4A7C15L + patch) * 0xD1B54A32D192ED03L;
    }

    public CellStore cells() {
        return cells;
    }

    /** The cells of a mesh half as fine. */
    public CellStore largeCells() {
        return largeCells;
    }

    /** Follows the light of the pass along the ways of its cells, for one task. The pass must have been run. */
    public LightPaths lightPaths() {
        return new MeshLightPaths(lattices, new WayTracer(plan));
    }

    public EnergyLedger ledger() {
        return ledger;
    }

    public ForwardCounters counters() {
        return counters;
    }
}
