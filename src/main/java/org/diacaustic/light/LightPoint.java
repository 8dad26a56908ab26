package org.diacaustic.light;

/** A point that sends out light rays. Mutable, owned by one task. */
public final class LightPoint {
    /** In scene units; of no meaning for parallel rays. */
    public double x;

    public double y;
    public double z;

    /** The unit normal of the light's surface there, or the direction of parallel rays; zero for a light without extent. */
    public double normalX;

    public double normalY;
    public double normalZ;

    void set(double px, double py, double pz, double nx, double ny, double nz) {
        x = px;
        y = py;
        z = pz;
        normalX = nx;
        normalY = ny;
        normalZ = nz;
    }
}
