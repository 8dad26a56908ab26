package org.diacaustic.chart;

import org.diacaustic.image.LinearImage;

/** Draws into a picture, two pixels for each unit. */
public final class PixelCanvas implements Canvas {
    private static final int SCALE = 2;

    private final LinearImage image;

    public PixelCanvas(int width, int height) {
        image = new LinearImage(SCALE * width, SCALE * height);
        fill(0, 0, width, height, Ink.PAPER);
    }

    public LinearImage image() {
        return image;
    }

    @Override
    public void fill(double x, double y, double width, double height, Ink ink) {
        fillPixels(pixel(x), pixel(y), pixel(x + width), pixel(y + height), ink);
    }

    @Override
    public void outline(double x, double y, double width, double height, Ink ink) {
        int left = pixel(x);
        int top = pixel(y);
        int right = pixel(x + width);
        int bottom = pixel(y + height);
        fillPixels(left, top, right, top + SCALE, ink);
        fillPixels(left, bottom - SCALE, right, bottom, ink);
        fillPixels(left, top, left + SCALE, bottom, ink);
        fillPixels(right - SCALE, top, right, bottom, ink);
    }

    @Override
    public void text(double x, double y, String text) {
        int top = pixel(y) - SCALE * PixelFont.HEIGHT;
        for (int i = 0; i < text.length(); i++) {
            int left = pixel(x) + SCALE * PixelFont.ADVANCE * i;
            for (int row = 0; row < PixelFont.HEIGHT; row++) {
                for (int column = 0; column < PixelFont.WIDTH; column++) {
                    if (PixelFont.isSet(text.charAt(i), row, column)) {
                        int dotX = left + SCALE * column;
                        int dotY = top + SCALE * row;
                        fillPixels(dotX, dotY, dotX + SCALE, dotY + SCALE, Ink.TEXT);
                    }
                }
            }
        }
    }

    @Override
    public void textAround(double x, double y, String text) {
        text(x - PixelFont.width(text) / 2.0, y, text);
    }

    private static int pixel(double coordinate) {
        return (int) Math.rint(SCALE * coordinate);
    }

    private void fillPixels(int left, int top, int right, int bottom, Ink ink) {
        for (int y = Math.max(0, top); y < Math.min(bottom, image.height()); y++) {
            for (int x = Math.max(0, left); x < Math.min(right, image.width()); x++) {
                image.set(x, y, ink.red, ink.green, ink.blue);
            }
        }
    }
}
