package org.diacaustic.map;

import java.util.Arrays;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;

/**
 * Photons: where light landed, how much, and on which side of which object. Primitive arrays, no object per photon [Thesis
 * 6.5 names that as the bottleneck]. Tasks fill slices of their own, which are appended in the order of the tasks, so the
 * photons and their order do not depend on the number of threads.
 */
public final class PhotonStore {
    private final Vector3 origin;
    private final double powerUnit;
    private final int capacity;
    private int size;
    private float[] x = new float[0];
    private float[] y = new float[0];
    private float[] z = new float[0];
    private float[] red = new float[0];
    private float[] green = new float[0];
    private float[] blue = new float[0];
    private int[] normal = new int[0];
    private int[] receiver = new int[0];

    /**
     * @param origin positions are kept as single-precision offsets from here: the middle of what is lit
     * @param powerUnit a power of two about the size of a photon's power, in W, so that none is too small or large for
     *     single precision
     * @param capacity the most photons that may be stored
     */
    public PhotonStore(Vector3 origin, double powerUnit, int capacity) {
        this.origin = origin;
        this.powerUnit = powerUnit;
        this.capacity = capacity;
    }

    /** An empty slice for one task. */
    public PhotonSlice slice() {
        return new PhotonSlice(origin, powerUnit);
    }

    /**
     * Appends the photons of a slice.
     *
     * @throws IllegalStateException if they exceed the capacity
     */
    public void append(PhotonSlice slice) {
        long needed = (long) size + slice.size();
        if (needed > capacity) {
            throw new IllegalStateException("more than " + capacity + " photons");
        }
        reserve((int) needed);
        int left = slice.size();
        for (PhotonSlice.Chunk chunk : slice.chunks) {
            int count = Math.min(left, PhotonSlice.CHUNK);
            System.arraycopy(chunk.x, 0, x, size, count);
            System.arraycopy(chunk.y, 0, y, size, count);
            System.arraycopy(chunk.z, 0, z, size, count);
            System.arraycopy(chunk.red, 0, red, size, count);
            System.arraycopy(chunk.green, 0, green, size, count);
            System.arraycopy(chunk.blue, 0, blue, size, count);
            System.arraycopy(chunk.normal, 0, normal, size, count);
            System.arraycopy(chunk.receiver, 0, receiver, size, count);
            size += count;
            left -= count;
        }
    }

    private void reserve(int needed) {
        if (needed > x.length) {
            int length = (int) Math.min(capacity, Math.max(needed, x.length * 3L / 2));
            x = Arrays.copyOf(x, length);
            y = Arrays.copyOf(y, length);
            z = Arrays.copyOf(z, length);
            red = Arrays.copyOf(red, length);
            green = Arrays.copyOf(green, length);
            blue = Arrays.copyOf(blue, length);
            normal = Arrays.copyOf(normal, length);
            receiver = Arrays.copyOf(receiver, length);
        }
    }

    public int size() {
        return size;
    }

    /** Sets point, normal and receiver to those of photon i. */
    public void position(int i, SurfacePoint out) {
        out.x = x[i] + origin.x();
        out.y = y[i] + origin.y();
        out.z = z[i] + origin.z();
        Rgb direction = new Rgb();
        PackedNormal.unpack(normal[i], direction);
        double length = Math.sqrt(
                direction.red * direction.red + direction.green * direction.green + direction.blue * direction.blue);
        out.normalX = direction.red / length;
        out.normalY = direction.green / length;
        out.normalZ = direction.blue / length;
        out.object = receiver[i] >>> 1;
        out.front = (receiver[i] & 1) != 0;
    }

    /** Sets the power of photon i, in W. */
    public void power(int i, Rgb out) {
        out.set(red[i] * powerUnit, green[i] * powerUnit, blue[i] * powerUnit);
    }
}
