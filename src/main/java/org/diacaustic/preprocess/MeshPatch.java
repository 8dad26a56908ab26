package org.diacaustic.preprocess;

import org.diacaustic.map.CellSeed;
import org.diacaustic.map.CellSlice;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.SampleStream;

/**
 * Makes the cells of a patch of a lattice: the rays of a cell's corners, and of one place within it that is left to chance,
 * must all have come the same way; then it is triangles on what they lit, with the power that went in between them.
 * Otherwise it is quartered as often as that is worth it. Of light that has still come from some corners only, triangles
 * become lines and points. So all light is kept, and none twice.
 *
 * <p>Along with the cells goes a mesh of cells twice as large, from the same rays: how much the two differ tells their
 * error. Owned by one task, used for one patch after the other.
 */
final class MeshPatch {
    /** Parts of light weaker than this do not decide about cells. */
    static final double SIGNIFICANT = 0x1p-9;

    private final LeafTracer tracer;
    private final LeafTable leaves = new LeafTable();
    private final PlaceTable places = new PlaceTable();
    private final LightRay ray = new LightRay();
    private final SampleStream random = new SampleStream();
    private final SurfacePoint a = new SurfacePoint();
    private final SurfacePoint b = new SurfacePoint();
    private final SurfacePoint c = new SurfacePoint();
    private final Rgb power = new Rgb();
    private final CellSeed seed = new CellSeed();
    private MeshLattice lattice;
    private CellSlice cells;
    /** Null while the larger cells are made, which are no light of their own. */
    private EnergyLedger ledger;

    private int size;

    MeshPatch(LeafTracer tracer) {
        this.tracer = tracer;
    }

    /**
     * Makes the cells of a patch.
     *
     * @param streams of the places that are left to chance
     */
    void make(
            LatticePatch patch,
            long streams,
            CellSlice fine,
            CellSlice coarse,
            EnergyLedger taskLedger,
            ForwardCounters counters) {
        lattice = patch.lattice();
        seed.chart = patch.chart();
        int endColumn = patch.column() + patch.columns();
        int endRow = patch.row() + patch.rows();
        size = lattice.cellSize();
        leaves.clear();
        places.clear();
        tracer.startTask(leaves, counters);
        cells = fine;
        ledger = taskLedger;
        for (int row = patch.row(); row < endRow && !tracer.isStopped(); row++) {
            for (int column = patch.column(); column < endColumn; column++) {
                random.start(streams, row, column);
                double x = (column + 0.25 + 0.5 * random.nextDouble()) * size;
                double y = (row + 0.25 + 0.5 * random.nextDouble()) * size;
                makeFan(column * size, row * size, size, trace(x, y), lattice.depth());
            }
        }
        cells = coarse;
        ledger = null;
        for (int row = patch.row(); row < endRow && !tracer.isStopped(); row += 2) {
            for (int column = patch.column(); column < endColumn; column += 2) {
                int x = (column + 1) * size;
                int y = (row + 1) * size;
                makeFan(column * size, row * size, 2 * size, rayAt(x, y), lattice.depth());
            }
        }
    }

    /** A cell with a ray inside. */
    private void makeFan(int x, int y, int side, int inside, int depth) {
        int p = rayAt(x, y);
        int q = rayAt(x + side, y);
        int r = rayAt(x + side, y + side);
        int s = rayAt(x, y + side);
        if (depth > 0 && !leaves.agree(p, q, r, s, inside, worthwhile(depth))) {
            quarter(x, y, side, depth);
            return;
        }
        makeCells(p, q, inside);
        makeCells(q, r, inside);
        makeCells(r, s, inside);
        makeCells(s, p, inside);
    }

    private void quarter(int x, int y, int side, int depth) {
        int half = side / 2;
        makeQuad(x, y, half, depth - 1);
        makeQuad(x + half, y, half, depth - 1);
        makeQuad(x + half, y + half, half, depth - 1);
        makeQuad(x, y + half, half, depth - 1);
    }

    private void makeQuad(int x, int y, int side, int depth) {
        int p = rayAt(x, y);
        int q = rayAt(x + side, y);
        int r = rayAt(x + side, y + side);
        int s = rayAt(x, y + side);
        if (depth > 0 && !leaves.agree(p, q, r, s, p, worthwhile(depth))) {
            quarter(x, y, side, depth);
            return;
        }
        makeCells(p, q, r);
        makeCells(p, r, s);
    }

    /** The part of light from which on a cell is quartered for it: as much power as all light has in the smallest cells. */
    static double worthwhile(int depth) {
        return Math.max(SIGNIFICANT, Math.scalb(0.5, -2 * depth));
    }

    /**
     * Makes triangles of the light that came the same way from all three corners, lines between those of two, and points of
     * what else there is.
     */
    private void makeCells(int p, int q, int r) {
        seed.p0 = leaves.aimedP(p);
        seed.q0 = leaves.aimedQ(p);
        seed.p1 = leaves.aimedP(q);
        seed.q1 = leaves.aimedQ(q);
        seed.p2 = leaves.aimedP(r);
        seed.q2 = leaves.aimedQ(r);
        double measure = lattice.measure(seed);
        book(p, q, r, measure);
        double third = measure / 3;
        for (int leaf = leaves.firstLeaf(p); leaf < leaves.endLeaf(p); leaf++) {
            makeCell(leaf, leaves.alike(leaf, q), leaves.alike(leaf, r), third);
        }
        for (int leaf = leaves.firstLeaf(q); leaf < leaves.endLeaf(q); leaf++) {
            if (leaves.alike(leaf, p) < 0) {
                makeCell(leaf, -1, free(leaves.alike(leaf, r), p), third);
            }
        }
        for (int leaf = leaves.firstLeaf(r); leaf < leaves.endLeaf(r); leaf++) {
            if (leaves.alike(leaf, p) < 0 && free(leaves.alike(leaf, q), p) < 0) {
                makePoint(leaf, third);
            }
        }
    }

    /** A leaf, unless it belongs to one of that corner's: of three on a round surface, the middle one may be like both others. */
    private int free(int leaf, int corner) {
        return leaf >= 0 && leaves.alike(leaf, corner) < 0 ? leaf : -1;
    }

    /** Makes a cell of a leaf and those like it of other corners, if there are any. */
    private void makeCell(int leaf, int second, int third, double measure) {
        if (second < 0 && third < 0) {
            makePoint(leaf, measure);
            return;
        }
        power.set(0, 0, 0);
        leaves.place(leaf, a);
        leaves.addPower(leaf, measure, power);
        leaves.place(second < 0 ? third : second, b);
        leaves.addPower(second < 0 ? third : second, measure, power);
        if (second >= 0 && third >= 0) {
            leaves.place(third, c);
            leaves.addPower(third, measure, power);
            seed.path = leaves.signature(leaf);
            cells.addTriangle(a, b, c, power, seed);
        } else {
            cells.addTriangle(a, b, b, power);
        }
    }

    private void makePoint(int leaf, double measure) {
        leaves.place(leaf, a);
        power.set(0, 0, 0);
        leaves.addPower(leaf, measure, power);
        cells.addPoint(a, power);
    }

    private void book(int p, int q, int r, double measure) {
        if (ledger != null) {
            for (int account = 0; account < LeafTable.BOOKS; account++) {
                double sum = leaves.booked(p, account) + leaves.booked(q, account) + leaves.booked(r, account);
                ledger.add(account, measure / 3 * sum);
            }
        }
    }

    private int rayAt(int x, int y) {
        int found = places.find(x, y);
        if (found < 0) {
            found = trace(x, y);
            places.put(x, y, found);
        }
        return found;
    }

    private int trace(double x, double y) {
        double p = lattice.p(x);
        double q = lattice.q(y);
        lattice.chart().aim(p, q, ray);
        int number = tracer.trace(lattice.beam(), lattice.point(), ray, ray.measure / lattice.meanDensity());
        leaves.aimed(number, p, q);
        return number;
    }
}
