package org.diacaustic.image;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.io.IOException;
import java.util.Iterator;
import javax.imageio.IIOException;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;

/** Reads what the image readers of this JVM know (PNG, JPEG, BMP, GIF …), and undoes the sRGB curve. Alpha is left out. */
final class JdkImageReader {
    /** Room for the decoded picture of up to four 16-bit channels. */
    private static final int DECODING_BYTES_PER_PIXEL = 8;

    private JdkImageReader() {}

    /** Reads an image whose kind its content tells. */
    static LinearImage read(ImageSource source) throws IOException {
        try (ImageInputStream in = new MemoryCacheImageInputStream(source.in())) {
            Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
            if (!readers.hasNext()) {
                throw new IOException("the content is no image of a known kind");
            }
            return read(readers.next(), in, source);
        }
    }

    /** Reads an image by the given reader, which is disposed of. */
    static LinearImage read(ImageReader reader, ImageSource source) throws IOException {
        try (ImageInputStream in = new MemoryCacheImageInputStream(source.in())) {
            return read(reader, in, source);
        }
    }

    private static LinearImage read(ImageReader reader, ImageInputStream in, ImageSource source) throws IOException {
        String[] truncation = new String[1];
        reader.addIIOReadWarningListener((from, warning) -> {
            // The JPEG reader fills up a file that ends early with grey and only warns.
            if (warning.contains("Truncated") || warning.contains("Premature")) {
                truncation[0] = warning;
            }
        });
        try {
            reader.setInput(in, false, true);
            long width = reader.getWidth(0);
            long height = reader.getHeight(0);
            source.checkSize(width, height, DECODING_BYTES_PER_PIXEL * width * height);
            BufferedImage picture = reader.read(0);
            if (truncation[0] != null) {
                throw new IOException(truncation[0]);
            }
            return toLinear(picture);
        } catch (IIOException e) {
            // A heap that is too small is no fault of the file.
            if (e.getCause() instanceof OutOfMemoryError tooSmall) {
                throw tooSmall;
            }
            throw e;
        } catch (RuntimeException e) {
            // The readers answer broken content with whatever went wrong inside them.
            throw new IOException("the content is damaged (" + e + ")", e);
        } finally {
            reader.dispose();
        }
    }

    private static LinearImage toLinear(BufferedImage picture) {
        LinearImage image = new LinearImage(picture.getWidth(), picture.getHeight());
        int bits = directSampleBits(picture.getColorModel());
        for (int y = 0; y < image.height(); y++) {
            if (bits > 0) {
                rowOfSamples(picture.getRaster(), y, bits, image);
            } else {
                rowOfColours(picture, y, image);
            }
        }
        return image;
    }

    /**
     * The bits per sample if the samples are sRGB or grey codes as they stand, else 0. Grey must not go through the
     * colour model: Java takes its codes for linear light, which no grey file means.
     */
    private static int directSampleBits(ColorModel model) {
        ColorSpace space = model.getColorSpace();
        boolean known = space.isCS_sRGB() || space.getType() == ColorSpace.TYPE_GRAY;
        if (!known || !(model instanceof ComponentColorModel) || model.isAlphaPremultiplied()) {
            return 0;
        }
        return model.getTransferType() == DataBuffer.TYPE_BYTE || model.getTransferType() == DataBuffer.TYPE_USHORT
                ? model.getComponentSize(0)
                : 0;
    }

    private static void rowOfSamples(Raster raster, int y, int bits, LinearImage image) {
        int bands = raster.getNumBands();
        int[] codes = raster.getPixels(raster.getMinX(), raster.getMinY() + y, image.width(), 1, (int[]) null);
        double largest = (1 << bits) - 1;
        float[] samples = image.samples();
        int offset = image.offset(0, y);
        for (int x = 0; x < image.width(); x++) {
            for (int channel = 0; channel < 3; channel++) {
                int code = codes[bands * x + (bands >= 3 ? channel : 0)];
                samples[offset++] = bits == 8 ? SrgbCurve.decodeByte(code) : (float) SrgbCurve.decode(code / largest);
            }
        }
    }

    private static void rowOfColours(BufferedImage picture, int y, LinearImage image) {
        int[] colours = picture.getRGB(0, y, image.width(), 1, null, 0, image.width());
        float[] samples = image.samples();
        int offset = image.offset(0, y);
        for (int colour : colours) {
            samples[offset++] = SrgbCurve.decodeByte(colour >> 16 & 0xff);
            samples[offset++] = SrgbCurve.decodeByte(colour >> 8 & 0xff);
            samples[offset++] = SrgbCurve.decodeByte(colour & 0xff);
        }
    }
}
