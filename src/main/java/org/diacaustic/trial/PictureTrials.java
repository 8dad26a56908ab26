package org.diacaustic.trial;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.diacaustic.image.Exposure;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.ImageFormat;
import org.diacaustic.image.LinearImage;
import org.diacaustic.image.ToneMapping;
import org.diacaustic.math.Vector3;
import org.diacaustic.render.RenderJob;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.render.ResourceLimitException;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** What becomes of radiance in files. */
final class PictureTrials {
    /** Pictures of more pixels are not written, only asked about. */
    private static final long WRITTEN = 1 << 20;

    private PictureTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "srgb8",
                "The code that writers of 8-bit formats ask, with exposure 1 and the exact sRGB curve; what is not a number is 0.",
                PictureTrials::srgb);
        operations.add(
                "rgbe",
                "A picture of one pixel, written as a Radiance file and read again: exponent as expected, mantissas within 1, and the"
                        + " colour that is read within relative_step of the largest channel.",
                PictureTrials::rgbe);
        operations.add("exposure", "The exponential tone mapping of exposure k.", PictureTrials::exposure);
        operations.add(
                "image_size",
                "What the scene file, the formats and the plan of a render say of the size, before anything is allocated; the Radiance"
                        + " rows of that width as they are written.",
                PictureTrials::sizes);
    }

    private static void srgb(NumericCase asked, Checks checks) {
        double[] linear = asked.inputs().numbers("linear");
        List<?> expected = asked.expected().list("srgb8");
        checks.same("length of srgb8", expected.size(), linear.length);
        Exposure exposure = Exposure.fixed(1);
        for (int i = 0; i < linear.length; i++) {
            int wanted = expected.get(i) instanceof Number code ? code.intValue() : 0;
            checks.same("srgb8 of " + linear[i], wanted, exposure.srgb8(linear[i]));
        }
    }

    private static void rgbe(NumericCase asked, Checks checks) throws IOException {
        double[][] colours = asked.inputs().rows("rgb");
        double[][] expected = asked.expected().rows("rgbe");
        double step = asked.expected().number("relative_step", 0x1p-8);
        checks.same("length of rgbe", expected.length, colours.length);
        for (int i = 0; i < colours.length; i++) {
            double[] colour = colours[i];
            LinearImage image = new LinearImage(1, 1);
            image.set(0, 0, colour[0], colour[1], colour[2]);
            byte[] file = ImageFiles.bytes(image, Exposure.fixed(1), ImageFormat.HDR);
            for (int channel = 0; channel < 4; channel++) {
                int got = file[file.length - 4 + channel] & 0xff;
                boolean isExponent = channel == 3;
                checks.rule(
                        "byte " + channel + " of pixel " + i,
                        Integer.toString((int) expected[i][channel]) + (isExponent ? "" : " +-1"),
                        Integer.toString(got),
                        Math.abs(got - expected[i][channel]) <= (isExponent ? 0 : 1));
            }
            if (expected[i][3] > 0) {
                float[] read = read(file).samples();
                double largest = Math.max(colour[0], Math.max(colour[1], colour[2]));
                for (int channel = 0; channel < 3; channel++) {
                    checks.number("pixel " + i + " read", Math.max(0, colour[channel]), read[channel], step * largest);
                }
            }
        }
    }

    private static LinearImage read(byte[] bytes) throws IOException {
        Path file = Files.createTempFile("pixel", ".hdr");
        try {
            Files.write(file, bytes);
            return ImageFiles.read(file);
        } finally {
            Files.delete(file);
        }
    }

    private static void exposure(NumericCase asked, Checks checks) {
        Exposure exposure = Exposure.fixed(asked.inputs().number("k")).with(ToneMapping.EXPONENTIAL);
        double[] radiance = asked.inputs().numbers("L");
        double[] got = new double[radiance.length];
        for (int i = 0; i < got.length; i++) {
            got[i] = exposure.display(radiance[i]);
        }
        checks.numbers("value", got, "value");
    }

    private static void sizes(NumericCase asked, Checks checks) {
        double[][] sizes = asked.inputs().rows("sizes");
        List<String> results = asked.expected().texts("result");
        double[] pixels = asked.expected().has("pixels") ? asked.expected().numbers("pixels") : new double[0];
        checks.same("length of result", sizes.length, results.size());
        for (int i = 0; i < sizes.length; i++) {
            String name = (long) sizes[i][0] + " x " + (long) sizes[i][1];
            for (String rule : results.get(i).toLowerCase(Locale.ROOT).split(";")) {
                rule(rule.strip(), name, sizes[i], checks);
            }
            if (i < pixels.length && pixels[i] > 0) {
                checks.same(
                        "pixels of " + name, (long) pixels[i], plan(sizes[i]).imageBytes() / (3L * Float.BYTES));
            }
        }
    }

    private static void rule(String rule, String name, double[] size, Checks checks) {
        int width = (int) size[0];
        int height = (int) size[1];
        if (rule.startsWith("tga:")) {
            checks.same(name + ": TGA is refused", rule.contains("reject"), isRefused(ImageFormat.TGA, width, height));
        } else if (rule.startsWith("hdr:")) {
            checks.same(name + ": HDR rows are flat", rule.contains("flat"), isFlat(width));
        } else if (rule.contains("reject")) {
            checks.holds(
                    name + ": the scene file is refused",
                    Stage.faults(sceneOf(size)).stream().anyMatch(fault -> fault.contains("camera.size")));
        } else if (rule.startsWith("ok")) {
            checks.same(name + ": faults of the scene file", List.of(), Stage.faults(sceneOf(size)));
            for (ImageFormat format : ImageFormat.values()) {
                checks.holds(name + ": can be written as " + format, isWritten(format, width, height));
            }
        } else if (rule.startsWith("refuse")) {
            checks.holds(name + ": refused before it is allocated", exceedsMemory(size));
        } else {
            throw new CaseFault("expected.result says of " + name + " what is not understood: " + rule);
        }
    }

    private static String sceneOf(double[] size) {
        return "{camera: {from: [0, 0, 5], to: [0, 0, 0], size: [" + (long) size[0] + ", " + (long) size[1] + "]}}";
    }

    private static boolean isRefused(ImageFormat format, int width, int height) {
        try {
            format.checkSize(width, height);
            return false;
        } catch (IllegalArgumentException tooLarge) {
            return true;
        }
    }

    private static boolean isWritten(ImageFormat format, int width, int height) {
        if (isRefused(format, width, height)) {
            return false;
        }
        return (long) width * height > WRITTEN
                || ImageFiles.bytes(new LinearImage(width, height), Exposure.fixed(1), format).length > 0;
    }

    /** Whether a row of that width begins with a pixel, and not with the mark of run lengths. */
    private static boolean isFlat(int width) {
        byte[] file = ImageFiles.bytes(new LinearImage(width, 1), Exposure.fixed(1), ImageFormat.HDR);
        String header = new String(file, 0, Math.min(file.length, 128), java.nio.charset.StandardCharsets.ISO_8859_1);
        int row = header.indexOf('\n', header.indexOf("-Y")) + 1;
        return file.length - row == 4 * width && file[row] != 2;
    }

    private static RenderPlan plan(double[] size) {
        Scene scene = Scene.builder()
                .camera(Stage.eye(Vector3.ZERO, Vector3.UNIT_X).withSize((int) size[0], (int) size[1]))
                .build();
        return RenderPlan.of(scene, Settings.physical());
    }

    private static boolean exceedsMemory(double[] size) {
        try {
            new RenderJob(plan(size));
            return false;
        } catch (ResourceLimitException refused) {
            return true;
        }
    }
}
