package org.diacaustic.preprocess;

/** A light ray that is about to be sent out, and how much of light space it stands for. Mutable, owned by one task. */
public final class LightRay {
    /** Where it starts, in scene units. */
    public double originX;

    public double originY;
    public double originZ;

    /** Where it goes, of length 1. */
    public double directionX;

    public double directionY;
    public double directionZ;

    /** What it stands for: solid angle in sr, or, among parallel rays, area across them in scene units squared. */
    public double measure;

    void setOrigin(double x, double y, double z) {
        originX = x;
        originY = y;
        originZ = z;
    }

    void setDirection(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        directionX = x / length;
        directionY = y / length;
        directionZ = z / length;
    }
}
