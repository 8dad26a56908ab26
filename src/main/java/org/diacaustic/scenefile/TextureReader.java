package org.diacaustic.scenefile;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.function.Function;
import org.diacaustic.image.ImageFiles;
import org.diacaustic.image.ImageTooLargeException;
import org.diacaustic.image.LinearImage;
import org.diacaustic.material.ConstantTexture;
import org.diacaustic.material.ImageTexture;
import org.diacaustic.material.MappedTexture;
import org.diacaustic.material.Pattern;
import org.diacaustic.material.PatternTexture;
import org.diacaustic.material.Texture;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.CylindricalMapping;
import org.diacaustic.shape.InverseMapping;
import org.diacaustic.shape.PlanarMapping;
import org.diacaustic.shape.SphericalMapping;

/** Reads a colour or a texture. */
final class TextureReader {
    /** Larger pictures are refused before they are decoded. */
    private static final long LARGEST_IMAGE_BYTES = 512L << 20;

    private static final Map<String, Function<MappingReader, Texture>> KINDS = new Kinds<
                    Function<MappingReader, Texture>>()
            .with("checker", TextureReader::checker)
            .with("stripes", TextureReader::stripes)
            .with("marble", TextureReader::marble)
            .with("clouds", TextureReader::clouds)
            .with("image", TextureReader::image)
            .map();

    private static final Map<String, Function<MappingReader, InverseMapping>> MAPPINGS = new Kinds<
                    Function<MappingReader, InverseMapping>>()
            .with("planar", TextureReader::planar)
            .with("spherical", TextureReader::spherical)
            .with("cylindrical", TextureReader::cylindrical)
            .map();

    private TextureReader() {}

    /** A colour or texture of values within 0 and 1; black if it is missing. */
    static Texture fraction(MappingReader in, String key) {
        return read(in, key, 1);
    }

    static Texture read(MappingReader in, String key, double largest) {
        if (in.form(key) == Form.MAPPING) {
            return in.variant(key).read(KINDS).orElse(ConstantTexture.BLACK);
        }
        return new ConstantTexture(in.color(key).atLeast(0).atMost(largest).or(Color.BLACK));
    }

    private static Texture checker(MappingReader in) {
        Color[] colors = colors(in);
        if (in.has("columns") || in.has("rows")) {
            int columns = in.integer("columns").atLeast(1).required();
            int rows = in.integer("rows").atLeast(1).required();
            return mapped(in, () -> new PatternTexture(new Pattern.MapChecker(columns, rows), colors[0], colors[1]));
        }
        double size = in.number("size").above(0).required();
        return Building.of(in, () -> new PatternTexture(new Pattern.Checker(size), colors[0], colors[1]));
    }

    private static Texture stripes(MappingReader in) {
        Color[] colors = colors(in);
        Vector3 direction = in.direction("direction").or(Vector3.UNIT_X);
        double length = in.number("length").above(0).required();
        return Building.of(in, () -> new PatternTexture(new Pattern.Stripes(direction, length), colors[0], colors[1]));
    }

    private static Texture marble(MappingReader in) {
        Color[] colors = colors(in);
        double size = in.number("size").above(0).required();
        double turbulence = in.number("turbulence").atLeast(0).or(1.0);
        return Building.of(in, () -> new PatternTexture(new Pattern.Marble(size, turbulence), colors[0], colors[1]));
    }

    private static Texture clouds(MappingReader in) {
        Color[] colors = colors(in);
        double size = in.number("size").above(0).required();
        return Building.of(in, () -> new PatternTexture(new Pattern.Clouds(size), colors[0], colors[1]));
    }

    private static Color[] colors(MappingReader in) {
        return new Color[] {
            in.color("first").atLeast(0).or(Color.WHITE),
            in.color("second").atLeast(0).or(Color.BLACK)
        };
    }

    private static Texture image(MappingReader in) {
        LinearImage picture = imageFile(in);
        int[] repeat = repeat(in);
        return mapped(in, () -> new ImageTexture(picture, repeat[0], repeat[1]));
    }

    /** The picture of the file named under {@code file}; one black pixel if it cannot be had, which has been told. */
    static LinearImage imageFile(MappingReader in) {
        Path file = in.file("file").required();
        if (!file.toString().isEmpty()) {
            try {
                return ImageFiles.read(file, LARGEST_IMAGE_BYTES);
            } catch (ImageTooLargeException tooLarge) {
                in.limit("file", tooLarge.getMessage());
            } catch (IOException broken) {
                in.unreadable("file", broken.getMessage());
            }
        }
        return new LinearImage(1, 1);
    }

    /** How often a picture is repeated across and up the map. */
    static int[] repeat(MappingReader in) {
        double[] repeat = in.numbers("repeat", 2).or(new double[] {1, 1});
        for (double times : repeat) {
            if (times < 1 || times != Math.rint(times) || times > 1 << 20) {
                in.error("repeat", "expected 2 whole numbers of at least 1, found " + times);
                return new int[] {1, 1};
            }
        }
        return new int[] {(int) repeat[0], (int) repeat[1]};
    }

    /** A texture on the map that {@code mapping} describes, or on the shape's own. */
    private static Texture mapped(MappingReader in, java.util.function.Supplier<Texture> texture) {
        if (!in.has("mapping")) {
            return Building.of(in, texture);
        }
        InverseMapping mapping = in.variant("mapping").read(MAPPINGS).orElse(null);
        return Building.of(in, () -> new MappedTexture(texture.get(), mapping));
    }

    private static InverseMapping planar(MappingReader in) {
        Vector3 corner = in.vector3("corner").required();
        Vector3 across = in.direction("across").required();
        Vector3 along = in.direction("along").required();
        return Building.of(in, () -> new PlanarMapping(corner, across, along));
    }

    private static InverseMapping spherical(MappingReader in) {
        Vector3 centre = in.vector3("at").required();
        Vector3 pole = in.direction("pole").or(Vector3.UNIT_Y);
        Vector3 equator = in.direction("equator").or(Vector3.UNIT_X);
        return Building.of(in, () -> new SphericalMapping(centre, pole, equator));
    }

    private static InverseMapping cylindrical(MappingReader in) {
        Vector3 from = in.vector3("from").required();
        Vector3 to = in.vector3("to").required();
        return Building.of(in, () -> new CylindricalMapping(from, to.minus(from)));
    }
}
