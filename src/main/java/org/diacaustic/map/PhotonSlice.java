package org.diacaustic.map;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;

/** The photons of one task, in the order in which they were stored; see {@link PhotonStore}. Owned by one task. */
public final class PhotonSlice {
    static final int CHUNK = 1 << 12;

    final List<Chunk> chunks = new ArrayList<>();
    private final Vector3 origin;
    private final double inversePowerUnit;
    private Chunk last;
    private int used = CHUNK;

    PhotonSlice(Vector3 origin, double powerUnit) {
        this.origin = origin;
        this.inversePowerUnit = 1 / powerUnit;
    }

    /** Stores a photon, the power in W. */
    public void add(SurfacePoint at, Rgb power) {
        if (used == CHUNK) {
            last = new Chunk();
            chunks.add(last);
            used = 0;
        }
        int i = used++;
        last.x[i] = (float) (at.x - origin.x());
        last.y[i] = (float) (at.y - origin.y());
        last.z[i] = (float) (at.z - origin.z());
        last.red[i] = (float) (power.red * inversePowerUnit);
        last.green[i] = (float) (power.green * inversePowerUnit);
        last.blue[i] = (float) (power.blue * inversePowerUnit);
        last.normal[i] = PackedNormal.of(at.normalX, at.normalY, at.normalZ);
        last.receiver[i] = at.object << 1 | (at.front ? 1 : 0);
    }

    public int size() {
        return chunks.isEmpty() ? 0 : (chunks.size() - 1) * CHUNK + used;
    }

    /** Room for {@link #CHUNK} photons, an array for each of their numbers. */
    static final class Chunk {
        final float[] x = new float[CHUNK];
        final float[] y = new float[CHUNK];
        final float[] z = new float[CHUNK];
        final float[] red = new float[CHUNK];
        final float[] green = new float[CHUNK];
        final float[] blue = new float[CHUNK];
        final int[] normal = new int[CHUNK];
        final int[] receiver = new int[CHUNK];
    }
}
