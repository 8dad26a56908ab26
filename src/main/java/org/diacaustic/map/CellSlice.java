package org.diacaustic.map;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;

/** The cells of one task, in the order in which they were stored; see {@link CellStore}. Owned by one task. */
public final class CellSlice {
    final List<CellChunk> chunks = new ArrayList<>();
    private final ChunkPool<CellChunk> pool;
    private final double originX;
    private final double originY;
    private final double originZ;
    private final double inverseLengthUnit;
    private final double inversePowerUnit;
    private final boolean keepsSeeds;
    private CellChunk last;
    private int used = CellChunk.SIZE;
    private long rejected;

    CellSlice(ChunkPool<CellChunk> pool, Vector3 origin, double lengthUnit, double powerUnit, boolean keepsSeeds) {
        this.pool = pool;
        this.originX = origin.x();
        this.originY = origin.y();
        this.originZ = origin.z();
        this.inverseLengthUnit = 1 / lengthUnit;
        this.inversePowerUnit = 1 / powerUnit;
        this.keepsSeeds = keepsSeeds;
    }

    /**
     * Stores a triangle of light on one side of one object, which {@code a} tells. It may be as thin as a line or as small
     * as a point. One whose numbers are not finite, or whose size or power is beyond single precision, or whose power is
     * negative, or whose normals add up to 0, is counted and left out.
     *
     * @param power of the whole triangle, evenly spread over it, in W
     * @throws PhotonCapacityException if the slices of the store together hold more than it may; thrown once a chunk is
     *     full, or else by {@link CellStore#append}
     */
    public void addTriangle(SurfacePoint a, SurfacePoint b, SurfacePoint c, Rgb power) {
        if (add(a, b, c, power) && keepsSeeds) {
            last.seeds.writeNone(used - 1);
        }
    }

    /** Stores a triangle of light with its seed, if seeds are kept. */
    public void addTriangle(SurfacePoint a, SurfacePoint b, SurfacePoint c, Rgb power, CellSeed seed) {
        if (add(a, b, c, power) && keepsSeeds) {
            last.seeds.write(used - 1, seed);
        }
    }

    /** Stores a triangle without seed; false if it is left out. */
    private boolean add(SurfacePoint a, SurfacePoint b, SurfacePoint c, Rgb power) {
        double x = (a.x - originX) * inverseLengthUnit;
        double y = (a.y - originY) * inverseLengthUnit;
        double z = (a.z - originZ) * inverseLengthUnit;
        double bx = (b.x - a.x) * inverseLengthUnit;
        double by = (b.y - a.y) * inverseLengthUnit;
        double bz = (b.z - a.z) * inverseLengthUnit;
        double cx = (c.x - a.x) * inverseLengthUnit;
        double cy = (c.y - a.y) * inverseLengthUnit;
        double cz = (c.z - a.z) * inverseLengthUnit;
        double normalX = a.normalX + b.normalX + c.normalX;
        double normalY = a.normalY + b.normalY + c.normalY;
        double normalZ = a.normalZ + b.normalZ + c.normalZ;
        double normal = Math.abs(normalX) + Math.abs(normalY) + Math.abs(normalZ);
        float red = (float) (power.red * inversePowerUnit);
        float green = (float) (power.green * inversePowerUnit);
        float blue = (float) (power.blue * inversePowerUnit);
        if (!(isSize(x, y, z) && isSize(bx, by, bz) && isSize(cx, cy, cz))
                || !(isPower(red) && isPower(green) && isPower(blue))
                || !(normal > 0 && normal <= Double.MAX_VALUE)) {
            rejected++;
            return false;
        }
        if (used == CellChunk.SIZE) {
            addChunk();
        }
        double[] vertices = last.vertices;
        float[] numbers = last.numbers;
        int place = used++;
        int i = 3 * place;
        vertices[i] = x;
        vertices[i + 1] = y;
        vertices[i + 2] = z;
        i = 9 * place;
        numbers[i] = (float) bx;
        numbers[i + 1] = (float) by;
        numbers[i + 2] = (float) bz;
        numbers[i + 3] = (float) cx;
        numbers[i + 4] = (float) cy;
        numbers[i + 5] = (float) cz;
        numbers[i + 6] = red;
        numbers[i + 7] = green;
        numbers[i + 8] = blue;
        last.tags[2 * place] = PackedNormal.of(normalX, normalY, normalZ);
        last.tags[2 * place + 1] = a.object << 1 | (a.front ? 1 : 0);
        return true;
    }

    /** Stores power, in W, that is all at one point: a triangle of three equal vertices. */
    public void addPoint(SurfacePoint at, Rgb power) {
        addTriangle(at, at, at, power);
    }

    private static boolean isSize(double x, double y, double z) {
        return Math.abs(x) <= Float.MAX_VALUE && Math.abs(y) <= Float.MAX_VALUE && Math.abs(z) <= Float.MAX_VALUE;
    }

    private static boolean isPower(float value) {
        return value >= 0 && value <= Float.MAX_VALUE;
    }

    private void addChunk() {
        if (last != null) {
            pool.count(CellChunk.SIZE);
        }
        last = pool.take();
        chunks.add(last);
        used = 0;
    }

    /** Whether the seeds of cells are kept. */
    public boolean keepsSeeds() {
        return keepsSeeds;
    }

    /** The number of cells stored. */
    public int size() {
        return chunks.isEmpty() ? 0 : (chunks.size() - 1) * CellChunk.SIZE + used;
    }

    /** The number of cells left out. */
    public long rejectedCount() {
        return rejected;
    }

    /** Counts the cells of the last chunk, which are not yet. */
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
        used = CellChunk.SIZE;
        rejected = 0;
    }
}
