package org.diacaustic.map;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.diacaustic.math.Vector3;

/**
 * Cells of light: triangles on receivers with the power they carry, and points of power. Primitive arrays, no object per cell,
 * 68 bytes each, and 60 more if their seeds are kept. Tasks fill slices of their own, which are appended in the order of the tasks, so the cells and their order
 * do not depend on the number of threads. Slices and store take their room from one pool, as those of a
 * {@link PhotonStore} do.
 */
public final class CellStore {
    /** No store may hold more: arrays of a {@link CausticMesh} have no more places. */
    public static final int LARGEST_CAPACITY = Integer.MAX_VALUE / 16;

    private final Vector3 origin;
    private final double lengthUnit;
    private final double powerUnit;
    private final boolean keepsSeeds;
    private final ChunkPool<CellChunk> pool;
    private final List<CellChunk> chunks = new ArrayList<>();
    private int used = CellChunk.SIZE;
    private long rejected;

    /** A store in scene units and W. */
    public CellStore(Vector3 origin, double powerUnit, int capacity) {
        this(origin, 1, powerUnit, capacity, false);
    }

    /**
     * @param origin the middle of what is lit: where the numbers that a mesh keeps are the most exact
     * @param lengthUnit about the size of what is lit, in scene units: then what is rounded, and how, does not depend on the
     *     scale of the scene
     * @param powerUnit about a cell's power, in W, so that none is too small or large for single precision: powers below 2^-149
     *     units become 0, those from 2^128 units on are left out and counted
     * @param capacity the most cells that may be stored
     * @throws IllegalArgumentException if the origin is not finite, a unit not a positive number, or the capacity negative
     *     or above {@link #LARGEST_CAPACITY}
     */
    public CellStore(Vector3 origin, double lengthUnit, double powerUnit, int capacity) {
        this(origin, lengthUnit, powerUnit, capacity, false);
    }

    private CellStore(Vector3 origin, double lengthUnit, double powerUnit, int capacity, boolean keepsSeeds) {
        if (!origin.isFinite() || !isUnit(lengthUnit) || !isUnit(powerUnit)) {
            throw new IllegalArgumentException(
                    "cells need a finite origin and positive units of length and power, but have " + origin + ", "
                            + lengthUnit + " and " + powerUnit);
        }
        if (capacity > LARGEST_CAPACITY) {
            throw new IllegalArgumentException(
                    "a store of cells has a capacity of at most " + LARGEST_CAPACITY + ", not " + capacity);
        }
        this.origin = origin;
        this.lengthUnit = lengthUnit;
        this.powerUnit = powerUnit;
        this.keepsSeeds = keepsSeeds;
        this.pool = new ChunkPool<>(() -> new CellChunk(keepsSeeds), "cells", capacity);
    }

    private static boolean isUnit(double unit) {
        return unit > 0 && 1 / unit > 0 && 1 / unit <= Double.MAX_VALUE;
    }

    /** A store as the constructor makes it, that keeps the seeds of cells too, for {@link CausticMesh#lookup(LightPaths)}. */
    public static CellStore keepingSeeds(Vector3 origin, double lengthUnit, double powerUnit, int capacity) {
        return new CellStore(origin, lengthUnit, powerUnit, capacity, true);
    }

    /** An empty slice for one task; may be asked for on any thread. */
    public CellSlice slice() {
        return new CellSlice(pool, origin, lengthUnit, powerUnit, keepsSeeds);
    }

    /**
     * Appends the cells of a slice of this store, which is empty afterwards and may be filled again.
     *
     * @throws PhotonCapacityException if they exceed the capacity
     */
    public void append(CellSlice slice) {
        slice.countRest();
        rejected += slice.rejectedCount();
        int left = slice.size();
        for (int i = 0; left > 0; i++) {
            int count = Math.min(left, CellChunk.SIZE);
            append(slice.chunks.get(i), count);
            left -= count;
        }
        slice.release();
    }

    private void append(CellChunk chunk, int count) {
        int place = 0;
        while (place < count) {
            if (used == CellChunk.SIZE) {
                chunks.add(pool.take());
                used = 0;
            }
            int next = Math.min(count - place, CellChunk.SIZE - used);
            chunks.get(chunks.size() - 1).copy(chunk, place, used, next);
            place += next;
            used += next;
        }
    }

    /** Is empty from now on, and leaves the chunks to the collector. */
    void forget() {
        chunks.clear();
        used = CellChunk.SIZE;
        rejected = 0;
        pool.forget();
    }

    /** The number of cells stored. */
    public int size() {
        return chunks.isEmpty() ? 0 : (chunks.size() - 1) * CellChunk.SIZE + used;
    }

    /**
     * Reads a cell.
     *
     * @throws IndexOutOfBoundsException if there is none of that number
     */
    public void read(int cell, Cell out) {
        Objects.checkIndex(cell, size());
        CellChunk chunk = chunkOf(cell);
        int place = cell & CellChunk.SIZE - 1;
        for (int i = 0; i < 9; i++) {
            double offset = i < 3 ? 0 : chunk.numbers[9 * place + i - 3];
            out.vertices[i] = origin.component(i % 3) + (chunk.vertices[3 * place + i % 3] + offset) * lengthUnit;
        }
        int i = 9 * place + 6;
        out.power
                .set(chunk.numbers[i], chunk.numbers[i + 1], chunk.numbers[i + 2])
                .scale(powerUnit);
        int receiver = chunk.tags[2 * place + 1];
        out.object = receiver >>> 1;
        out.front = (receiver & 1) != 0;
        out.hasSeed = keepsSeeds && chunk.seeds.read(place, out.seed);
    }

    /** The number of cells left out because their numbers were not finite or their power negative. */
    public long rejectedCount() {
        return rejected;
    }

    /** The memory that the cells take. */
    public long bytes() {
        return chunks.size() * (CellChunk.BYTES + (keepsSeeds ? CellChunk.SIZE * CellSeeds.BYTES : 0));
    }

    /** Whether the seeds of cells are kept. */
    public boolean keepsSeeds() {
        return keepsSeeds;
    }

    Vector3 origin() {
        return origin;
    }

    /** In scene units. */
    double lengthUnit() {
        return lengthUnit;
    }

    double powerUnit() {
        return powerUnit;
    }

    /** The chunk of a cell. */
    CellChunk chunkOf(int cell) {
        return chunks.get(cell >> CellChunk.BITS);
    }
}
