package org.diacaustic.map;

import org.diacaustic.math.Rgb;

/** The photons of a store in arrays, in any order that is wanted: what the indices that lost are made of. */
final class PhotonColumns {
    final float[] x;
    final float[] y;
    final float[] z;
    final float[] red;
    final float[] green;
    final float[] blue;
    final int[] normal;

    PhotonColumns(int size) {
        x = new float[size];
        y = new float[size];
        z = new float[size];
        red = new float[size];
        green = new float[size];
        blue = new float[size];
        normal = new int[size];
    }

    static PhotonColumns of(PhotonStore store) {
        PhotonColumns columns = new PhotonColumns(store.size());
        SurfacePoint at = new SurfacePoint();
        Rgb power = new Rgb();
        for (int i = 0; i < store.size(); i++) {
            store.position(i, at);
            store.power(i, power);
            columns.x[i] = (float) at.x;
            columns.y[i] = (float) at.y;
            columns.z[i] = (float) at.z;
            columns.red[i] = (float) power.red;
            columns.green[i] = (float) power.green;
            columns.blue[i] = (float) power.blue;
            columns.normal[i] = PackedNormal.of(at.normalX, at.normalY, at.normalZ);
        }
        return columns;
    }

    int size() {
        return x.length;
    }

    long bytes() {
        return 28L * x.length;
    }

    void copy(PhotonColumns from, int source, int target) {
        x[target] = from.x[source];
        y[target] = from.y[source];
        z[target] = from.z[source];
        red[target] = from.red[source];
        green[target] = from.green[source];
        blue[target] = from.blue[source];
        normal[target] = from.normal[source];
    }

    float distanceSquared(int i, float px, float py, float pz) {
        float dx = x[i] - px;
        float dy = y[i] - py;
        float dz = z[i] - pz;
        return dx * dx + dy * dy + dz * dz;
    }
}
