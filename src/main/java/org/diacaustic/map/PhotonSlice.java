package org.diacaustic.map;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;

/** The photons of one task, in the order in which they were stored; see {@link PhotonStore}. Owned by one task. */
public final class PhotonSlice {
    final List<PhotonChunk> chunks = new ArrayList<>();
    private final ChunkPool<PhotonChunk> pool;
    private final double originX;
    private final double originY;
    private final double originZ;
    private final double inverseLengthUnit;
    private final double inversePowerUnit;
    private PhotonChunk last;
    private int used = PhotonChunk.SIZE;
    private long rejected;

    PhotonSlice(ChunkPool<PhotonChunk> pool, Vector3 origin, double lengthUnit, double powerUnit) {
        this.pool = pool;
        this.originX = origin.x();
        this.originY = origin.y();
        this.originZ = origin.z();
        this.inverseLengthUnit = 1 / lengthUnit;
        this.inversePowerUnit = 1 / powerUnit;
    }

    /**
     * Stores a photon, the power in W. One whose numbers are not finite, or beyond single precision, or whose power is
     * negative, or whose normal is 0, is counted and left out.
     *
     * @throws PhotonCapacityException if the slices of the store together hold more than it may; thrown once a chunk is
     *     full, or else by {@link PhotonStore#append}
     */
    public void add(SurfacePoint at, Rgb power) {
        float x = (float) ((at.x - originX) * inverseLengthUnit);
        float y = (float) ((at.y - originY) * inverseLengthUnit);
        float z = (float) ((at.z - originZ) * inverseLengthUnit);
        float red = (float) (power.red * inversePowerUnit);
        float green = (float) (power.green * inversePowerUnit);
        float blue = (float) (power.blue * inversePowerUnit);
        double normal = Math.abs(at.normalX) + Math.abs(at.normalY) + Math.abs(at.normalZ);
        if (!(isFinite(x) && isFinite(y) && isFinite(z))
                || !(isPower(red) && isPower(green) && isPower(blue))
                || !(normal > 0 && normal <= Double.MAX_VALUE)) {
            rejected++;
            return;
        }
        if (used == PhotonChunk.SIZE) {
            addChunk();
        }
        int i = used++;
        last.x[i] = x;
        last.y[i] = y;
        last.z[i] = z;
        last.red[i] = red;
        last.green[i] = green;
        last.blue[i] = blue;
        last.normal[i] = PackedNormal.of(at.normalX, at.normalY, at.normalZ);
        last.receiver[i] = at.object << 1 | (at.front ? 1 : 0);
    }

    private static boolean isFinite(float value) {
        return Math.abs(value) <= Float.MAX_VALUE;
    }

    private static boolean isPower(float value) {
        return value >= 0 && value <= Float.MAX_VALUE;
    }

    private void addChunk() {
        if (last != null) {
            pool.count(PhotonChunk.SIZE);
        }
        last = pool.take();
        chunks.add(last);
        used = 0;
    }

    /** The number of photons stored. */
    public int size() {
        return chunks.isEmpty() ? 0 : (chunks.size() - 1) * PhotonChunk.SIZE + used;
    }

    /** The number of photons left out. */
    public long rejectedCount() {
        return rejected;
    }

    /** Counts the photons of the last chunk, which are not yet. */
    void countRest() {
        if (last != null) {
            pool.count(used);
        }
    }

    /** Gives the chunks back, and is empty again. */
    void release() {
        pool.give(chunks);
        chunks.clear();
        last = null;
        used = PhotonChunk.SIZE;
        rejected = 0;
    }
}
