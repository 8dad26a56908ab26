package org.diacaustic.preprocess;

import org.diacaustic.scene.SceneIndex;

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

    /** The object that the ray must meet first to count, or {@link SceneIndex#NONE} if any will do. */
    int targetObject = SceneIndex.NONE;

    /** Where it must meet that: in scene units from the start. */
    double targetDistance;

    /** How far off that it may be, in scene units. */
    double targetError;

    void aimAt(int object, double distance, double error) {
        targetObject = object;
        targetDistance = distance;
        targetError = error;
    }

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
