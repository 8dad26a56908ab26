package org.diacaustic.image;

import com.twelvemonkeys.imageio.plugins.tga.TGAImageReaderSpi;
import com.twelvemonkeys.imageio.plugins.tga.TGAImageWriterSpi;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import javax.imageio.IIOImage;
import javax.imageio.ImageReader;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Targa files, 24-bit true colour with run lengths, the first row at the top; by TwelveMonkeys ImageIO. */
final class TgaCodec implements ImageCodec {
    /**
     * The end of a version 2 file: no extension area, no developer area, the signature. Without it, the reader fails on
     * images of so few bytes that it looks for the footer in the header.
     */
    private static final byte[] FOOTER = "\0\0\0\0\0\0\0\0TRUEVISION-XFILE.\0".getBytes(StandardCharsets.US_ASCII);

    @Override
    public void write(LinearImage image, Exposure exposure, OutputStream out) throws IOException {
        BufferedImage picture = eightBit(image, exposure);
        ImageWriter writer = new TGAImageWriterSpi().createWriterInstance(null);
        try (ImageOutputStream file = new MemoryCacheImageOutputStream(out)) {
            ImageWriteParam settings = writer.getDefaultWriteParam();
            settings.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
            settings.setCompressionType("RLE");
            writer.setOutput(file);
            writer.write(null, new IIOImage(picture, null, null), settings);
        } finally {
            writer.dispose();
        }
        out.write(FOOTER);
    }

    private static BufferedImage eightBit(LinearImage image, Exposure exposure) {
        BufferedImage picture = new BufferedImage(image.width(), image.height(), BufferedImage.TYPE_3BYTE_BGR);
        byte[] bytes = ((DataBufferByte) picture.getRaster().getDataBuffer()).getData();
        float[] samples = image.samples();
        for (int i = 0; i < samples.length; i += 3) {
            bytes[i] = (byte) exposure.srgb8(samples[i + 2]);
            bytes[i + 1] = (byte) exposure.srgb8(samples[i + 1]);
            bytes[i + 2] = (byte) exposure.srgb8(samples[i]);
        }
        return picture;
    }

    @Override
    public LinearImage read(ImageSource source) throws IOException {
        ImageReader reader = new TGAImageReaderSpi().createReaderInstance(null);
        return JdkImageReader.read(reader, source);
    }
}
