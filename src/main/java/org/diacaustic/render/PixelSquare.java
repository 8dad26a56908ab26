package org.diacaustic.render;

import org.diacaustic.map.Footprint;
import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Ray;
import org.diacaustic.scene.Camera;

/** A square of the picture, a pixel or a part of it, and where the eye rays of its corners arrive. Owned by one task. */
final class PixelSquare {
    private final Camera camera;
    private final double[] points = new double[12];
    private final double[] directions = new double[12];
    private double sampleX;
    private double sampleY;
    private double lensU;
    private double lensV;
    private double left;
    private double top;
    private double side;

    PixelSquare(Camera camera) {
        this.camera = camera;
    }

    /** The eye ray that the squares are about; see {@link Camera#aim}. */
    void startSample(double x, double y, double onLensU, double onLensV) {
        sampleX = x;
        sampleY = y;
        lensU = onLensU;
        lensV = onLensV;
    }

    /** Is the whole pixel from now on. */
    void takePixel() {
        left = Math.floor(sampleX);
        top = Math.floor(sampleY);
        side = 1;
    }

    /** Is a square of this side, in pixels, around the sample. */
    void takeAround(double size) {
        side = size;
        left = sampleX - size / 2;
        top = sampleY - size / 2;
    }

    /** Is one of n × n equal parts of another square. */
    void takePart(PixelSquare whole, int number, int n) {
        sampleX = whole.sampleX;
        sampleY = whole.sampleY;
        lensU = whole.lensU;
        lensV = whole.lensV;
        side = whole.side / n;
        int row = number / n;
        int column = number % n;
        left = whole.left + column * side;
        top = whole.top + row * side;
    }

    /** The area on a plane across the view at a distance of 1. */
    double pictureArea() {
        return side * side * camera.pixelArea();
    }

    /** Aims at a corner: 0 to 3 around the square. */
    void aim(int corner, Ray ray) {
        double x = left + (corner == 1 || corner == 2 ? side : 0);
        double y = top + (corner >= 2 ? side : 0);
        camera.aim(x, y, lensU, lensV, ray);
    }

    void aimAtMiddle(Ray ray) {
        camera.aim(left + 0.5 * side, top + 0.5 * side, lensU, lensV, ray);
    }

    /** The angle between the rays of opposite corners. */
    double angle(Ray ray) {
        aim(0, ray);
        double x = ray.directionX;
        double y = ray.directionY;
        double z = ray.directionZ;
        aim(2, ray);
        return Arithmetic.length(ray.directionX - x, ray.directionY - y, ray.directionZ - z);
    }

    /** Notes where a corner's ray arrives, and with which direction. */
    void arrive(int corner, Ray ray, double x, double y, double z) {
        int i = 3 * corner;
        points[i] = x;
        points[i + 1] = y;
        points[i + 2] = z;
        directions[i] = ray.directionX;
        directions[i + 1] = ray.directionY;
        directions[i + 2] = ray.directionZ;
    }

    void addCorners(Footprint to) {
        for (int i = 0; i < 4; i++) {
            addCorner(to, i);
        }
    }

    /** Adds the triangle of a corner and the two that are opposite. */
    void addHalf(Footprint to, int corner) {
        addCorner(to, 0);
        addCorner(to, corner);
        addCorner(to, 2);
    }

    private void addCorner(Footprint to, int corner) {
        int i = 3 * corner;
        to.addCorner(points[i], points[i + 1], points[i + 2], directions[i], directions[i + 1], directions[i + 2]);
    }

    /** The longer of the diagonals between where the corners' rays arrive. */
    double diagonal() {
        return Math.max(distance(0, 2), distance(1, 3));
    }

    private double distance(int i, int j) {
        return Arithmetic.length(
                points[3 * i] - points[3 * j],
                points[3 * i + 1] - points[3 * j + 1],
                points[3 * i + 2] - points[3 * j + 2]);
    }
}
