package org.diacaustic.shader;

import java.util.Arrays;

/** The transparent surfaces on a shadow ray, sorted by distance from the lit point. */
final class Crossings {
    private int count;
    private double[] distance = new double[16];
    private int[] object = new int[16];
    private boolean[] entering = new boolean[16];
    private double[] cosine = new double[16];
    private double[] red = new double[16];
    private double[] green = new double[16];
    private double[] blue = new double[16];

    void clear() {
        count = 0;
    }

    int count() {
        return count;
    }

    /** Puts a surface in its place by distance; of equal ones the first stays first. */
    void add(double t, int objectNumber, boolean enters, double cos, double r, double g, double b) {
        if (count == distance.length) {
            grow();
        }
        int at = count++;
        while (at > 0 && distance[at - 1] > t) {
            move(at - 1, at);
            at--;
        }
        distance[at] = t;
        object[at] = objectNumber;
        entering[at] = enters;
        cosine[at] = cos;
        red[at] = r;
        green[at] = g;
        blue[at] = b;
    }

    double distance(int i) {
        return distance[i];
    }

    int object(int i) {
        return object[i];
    }

    /** Whether the line from the lit point to the light enters the object here. */
    boolean isEntering(int i) {
        return entering[i];
    }

    /** Cosine of the angle between the line and the normal, 0..1. */
    double cosine(int i) {
        return cosine[i];
    }

    double red(int i) {
        return red[i];
    }

    double green(int i) {
        return green[i];
    }

    double blue(int i) {
        return blue[i];
    }

    /** Scales what the surface lets through. */
    void scale(int i, double factor) {
        red[i] *= factor;
        green[i] *= factor;
        blue[i] *= factor;
    }

    /** Makes the surface let everything through: it separates nothing. */
    void open(int i) {
        red[i] = 1;
        green[i] = 1;
        blue[i] = 1;
    }

    private void move(int from, int to) {
        distance[to] = distance[from];
        object[to] = object[from];
        entering[to] = entering[from];
        cosine[to] = cosine[from];
        red[to] = red[from];
        green[to] = green[from];
        blue[to] = blue[from];
    }

    private void grow() {
        int size = 2 * count;
        distance = Arrays.copyOf(distance, size);
        object = Arrays.copyOf(object, size);
        entering = Arrays.copyOf(entering, size);
        cosine = Arrays.copyOf(cosine, size);
        red = Arrays.copyOf(red, size);
        green = Arrays.copyOf(green, size);
        blue = Arrays.copyOf(blue, size);
    }
}
