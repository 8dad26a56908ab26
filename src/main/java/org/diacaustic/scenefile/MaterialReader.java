package org.diacaustic.scenefile;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.diacaustic.material.BumpMap;
import org.diacaustic.material.ImageBump;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.material.Ripple;
import org.diacaustic.material.Texture;
import org.diacaustic.material.Wave;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;

/** Reads {@code materials}. */
final class MaterialReader {
    /** Fractions written in decimals may add up to a little more than 1. */
    private static final double ROUNDING = 0x1p-40;

    private MaterialReader() {}

    /** All materials by name; one that is wrong is there as null, so that its name is known. */
    static Map<String, Material> readAll(MappingReader root) {
        Map<String, Material> materials = new LinkedHashMap<>();
        root.namedMappings("materials").forEach((name, in) -> materials.put(name, read(in)));
        return materials;
    }

    static Material read(MappingReader in) {
        Texture diffuse = TextureReader.fraction(in, "diffuse");
        Texture ambient = TextureReader.read(in, "ambient", Double.POSITIVE_INFINITY);
        Texture reflectivity = TextureReader.fraction(in, "reflectivity");
        Texture transparency = TextureReader.fraction(in, "transparency");
        Medium inside = medium(in);
        Medium outside = in.optionalMapping("outside")
                .map(around -> {
                    Medium medium = medium(around);
                    around.finish();
                    return medium;
                })
                .orElse(Medium.VACUUM);
        List<BumpMap> waves =
                in.mappings("waves").stream().map(MaterialReader::wave).toList();
        List<BumpMap> ripples =
                in.mappings("ripples").stream().map(MaterialReader::ripple).toList();
        List<BumpMap> images = in.optionalMapping("bump-image").map(MaterialReader::imageBump).stream()
                .toList();
        return Building.of(in, () -> {
            Material.Builder material = Material.builder()
                    .diffuse(diffuse)
                    .ambient(ambient)
                    .reflectivity(reflectivity)
                    .transparency(transparency)
                    .inside(inside)
                    .outside(outside);
            waves.forEach(material::bump);
            ripples.forEach(material::bump);
            images.forEach(material::bump);
            Material made = material.build();
            if (made.largestConstantSum() > 1 + ROUNDING) {
                in.warning("diffuse, reflectivity and transparency add up to " + made.largestConstantSum()
                        + ": the surface sends out more light than it receives");
            }
            return made;
        });
    }

    private static Medium medium(MappingReader in) {
        double ior = in.number("ior").above(0).or(1.0);
        Color absorption = in.color("absorption").atLeast(0).or(Color.BLACK);
        int priority = in.integer("priority").atLeast(0).or(0);
        return new Medium(ior, absorption, priority);
    }

    private static BumpMap wave(MappingReader in) {
        Vector3 direction = horizontalOrSpatial(in);
        double length = in.number("length").above(0).required();
        double height = waveHeight(in, length);
        double phase = in.number("phase").in("degrees").or(0.0);
        return Building.of(in, () -> Wave.ofLength(direction, length, height, StrictMath.toRadians(phase)));
    }

    /** Two numbers are a direction along x and z, three one in space. */
    private static Vector3 horizontalOrSpatial(MappingReader in) {
        double[] numbers = in.numbers("direction").required();
        boolean wrong = numbers.length != 2 && numbers.length != 3;
        Vector3 direction = wrong
                ? Vector3.UNIT_X
                : numbers.length == 2
                        ? new Vector3(numbers[0], 0, numbers[1])
                        : new Vector3(numbers[0], numbers[1], numbers[2]);
        if (wrong || direction.length() == 0) {
            in.error("direction", "expected a direction, 2 numbers (x and z) or 3, not all 0");
            return Vector3.UNIT_X;
        }
        return direction;
    }

    /** A wave may give its steepest slope in place of its height. */
    private static double waveHeight(MappingReader in, double length) {
        if (!in.has("slope")) {
            return in.number("height").required();
        }
        if (in.has("height")) {
            in.error("height", "give either the height of a wave or its steepest slope, not both");
        }
        return in.number("slope").required() * length / (2 * Math.PI);
    }

    private static BumpMap ripple(MappingReader in) {
        Vector3 centre = in.vector3("at").required();
        double length = in.number("length").above(0).required();
        double height = waveHeight(in, length);
        double phase = in.number("phase").in("degrees").or(0.0);
        double reach = in.number("reach").above(0).or(Double.POSITIVE_INFINITY);
        return Building.of(
                in, () -> new Ripple(centre, 2 * Math.PI / length, height, StrictMath.toRadians(phase), reach));
    }

    private static BumpMap imageBump(MappingReader in) {
        double height = in.number("height").required();
        var image = TextureReader.imageFile(in);
        int[] repeat = TextureReader.repeat(in);
        return Building.of(in, () -> new ImageBump(image, height, repeat[0], repeat[1]));
    }
}
