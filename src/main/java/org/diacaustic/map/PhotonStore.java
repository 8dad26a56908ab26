package org.diacaustic.map;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;

/**
 * Photons: where light landed, how much, and on which side of which object. Primitive arrays, no object per photon [Thesis
 * 6.5 names that as the bottleneck], 32 bytes each. Tasks fill slices of their own, which are appended in the order of the
 * tasks, so the photons and their order do not depend on the number of threads. Slices and store take their room from one
 * pool: appending needs no more of it, and nothing is allocated for a photon once there are chunks to use again.
 */
public final class PhotonStore {
    private final Vector3 origin;
    private final double lengthUnit;
    private final double powerUnit;
    private final ChunkPool<PhotonChunk> pool;
    private final List<PhotonChunk> chunks = new ArrayList<>();
    private int used = PhotonChunk.SIZE;
    private long rejected;

    /** A store of positions in scene units. */
    public PhotonStore(Vector3 origin, double powerUnit, int capacity) {
        this(origin, 1, powerUnit, capacity);
    }

    /**
     * @param origin positions are kept as single-precision offsets from here: the middle of what is lit
     * @param lengthUnit about the size of what is lit, in scene units, so that offsets do not leave the range of single
     *     precision, and what is rounded, and how, does not depend on the scale of the scene: offsets below 2^-149 units become 0,
     *     photons 2^128 units off are left out and counted
     * @param powerUnit about the size of a photon's power, in W, so that none is too small or large for
     *     single precision: powers below 2^-149 units become 0, those from 2^128 units on are left out and counted
     * @param capacity the most photons that may be stored
     * @throws IllegalArgumentException if the origin is not finite, a unit not a positive number or the capacity
     *     negative
     */
    public PhotonStore(Vector3 origin, double lengthUnit, double powerUnit, int capacity) {
        if (!origin.isFinite() || !isUnit(lengthUnit) || !isUnit(powerUnit)) {
            throw new IllegalArgumentException(
                    "photons need a finite origin and positive units of length and power, but have " + origin + ", "
                            + lengthUnit + " and " + powerUnit);
        }
        this.origin = origin;
        this.lengthUnit = lengthUnit;
        this.powerUnit = powerUnit;
        this.pool = new ChunkPool<>(PhotonChunk::new, "photons", capacity);
    }

    private static boolean isUnit(double unit) {
        return unit > 0 && 1 / unit > 0 && 1 / unit <= Double.MAX_VALUE;
    }

    /** An empty slice for one task; may be asked for on any thread. */
    public PhotonSlice slice() {
        return new PhotonSlice(pool, origin, lengthUnit, powerUnit);
    }

    /**
     * Appends the photons of a slice of this store, which is empty afterwards and may be filled again.
     *
     * @throws PhotonCapacityException if they exceed the capacity
     */
    public void append(PhotonSlice slice) {
        slice.countRest();
        rejected += slice.rejectedCount();
        int left = slice.size();
        for (int i = 0; left > 0; i++) {
            int count = Math.min(left, PhotonChunk.SIZE);
            append(slice.chunks.get(i), count);
            left -= count;
        }
        slice.release();
    }

    private void append(PhotonChunk chunk, int count) {
        int place = 0;
        while (place < count) {
            if (used == PhotonChunk.SIZE) {
                chunks.add(pool.take());
                used = 0;
            }
            int next = Math.min(count - place, PhotonChunk.SIZE - used);
            chunks.get(chunks.size() - 1).copy(chunk, place, used, next);
            place += next;
            used += next;
        }
    }

    /** Takes all photons out, for a pass that stores anew; there must be no slice that is not appended. */
    public void clear() {
        pool.give(chunks);
        forget();
    }

    /** Is empty from now on, and leaves the chunks to whoever has taken them. */
    void forget() {
        chunks.clear();
        used = PhotonChunk.SIZE;
        rejected = 0;
        pool.forget();
    }

    /** The number of photons stored. */
    public int size() {
        return chunks.isEmpty() ? 0 : (chunks.size() - 1) * PhotonChunk.SIZE + used;
    }

    /** The number of photons left out because their numbers were not finite or their power negative. */
    public long rejectedCount() {
        return rejected;
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

    PhotonChunk chunk(int number) {
        return chunks.get(number);
    }

    void forEachChunk(Consumer<PhotonChunk> action) {
        chunks.forEach(action);
    }

    /** Sets point, normal and receiver to those of photon i. */
    public void position(int i, SurfacePoint out) {
        PhotonChunk chunk = chunks.get(i >> PhotonChunk.BITS);
        int place = i & PhotonChunk.SIZE - 1;
        out.x = chunk.x[place] * lengthUnit + origin.x();
        out.y = chunk.y[place] * lengthUnit + origin.y();
        out.z = chunk.z[place] * lengthUnit + origin.z();
        PackedNormal.unpack(chunk.normal[place], out);
        out.object = chunk.receiver[place] >>> 1;
        out.front = (chunk.receiver[place] & 1) != 0;
    }

    /** Sets the power of photon i, in W. */
    public void power(int i, Rgb out) {
        PhotonChunk chunk = chunks.get(i >> PhotonChunk.BITS);
        int place = i & PhotonChunk.SIZE - 1;
        out.set(chunk.red[place] * powerUnit, chunk.green[place] * powerUnit, chunk.blue[place] * powerUnit);
    }
}
