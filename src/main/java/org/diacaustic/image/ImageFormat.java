package org.diacaustic.image;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;

/** The kinds of image file that can be written, each chosen by the ending of the file's name. */
public enum ImageFormat {
    /** 8-bit sRGB, compressed without loss. */
    PNG("png", ImageFormat.LARGEST_SIDE, new PngCodec()),
    /** 8-bit sRGB, 24-bit true colour with run lengths, as the thesis wrote. */
    TGA("tga", 65535, new TgaCodec()),
    /** Linear radiance with a shared exponent, 8 bits of precision (Radiance RGBE). */
    HDR("hdr", ImageFormat.LARGEST_SIDE, new RadianceCodec()),
    /** Linear radiance as plain floats (portable float map). */
    PFM("pfm", ImageFormat.LARGEST_SIDE, new FloatMapCodec()),
    /** Linear radiance as floats, compressed without loss (OpenEXR). */
    EXR("exr", ImageFormat.LARGEST_SIDE, new ExrCodec());

    /** Rows this wide, and blocks of 16 of them, still fit an array in every format. */
    static final int LARGEST_SIDE = 1 << 23;

    private final String ending;
    private final int largestSide;
    private final ImageCodec codec;

    ImageFormat(String ending, int largestSide, ImageCodec codec) {
        this.ending = ending;
        this.largestSide = largestSide;
        this.codec = codec;
    }

    /**
     * The format that the ending of a file's name stands for, in lower or upper case.
     *
     * @throws IllegalArgumentException if it stands for none; the message lists those that are known
     */
    public static ImageFormat of(Path path) {
        String found = ending(path);
        for (ImageFormat format : values()) {
            if (format.ending.equals(found)) {
                return format;
            }
        }
        String known = Arrays.stream(values()).map(f -> "." + f.ending).collect(Collectors.joining(", "));
        String problem = found.isEmpty() ? " has no ending" : " has the unknown ending ." + found;
        throw new IllegalArgumentException(path + problem + "; an image can be written as " + known);
    }

    /** What follows the last dot of the file's name, in lower case; empty if there is none. */
    static String ending(Path path) {
        Path name = path.getFileName();
        String text = name == null ? "" : name.toString();
        int dot = text.lastIndexOf('.');
        return dot < 0 ? "" : text.substring(dot + 1).toLowerCase(Locale.ROOT);
    }

    /** The ending of file names, in lower case and without the dot. */
    public String ending() {
        return ending;
    }

    /** Whether files hold linear radiance; otherwise they hold sRGB of exposure × radiance. */
    public boolean isLinear() {
        return this == HDR || this == PFM || this == EXR;
    }

    /**
     * Checks, before anything is rendered or written, that the format can hold an image of this size.
     *
     * @throws IllegalArgumentException if it cannot
     */
    public void checkSize(int width, int height) {
        if (width > largestSide || height > largestSide) {
            throw new IllegalArgumentException("an image of " + width + " x " + height + " pixels is too large for "
                    + name() + ", whose sides are at most " + largestSide + " pixels");
        }
    }

    ImageCodec codec() {
        return codec;
    }
}
