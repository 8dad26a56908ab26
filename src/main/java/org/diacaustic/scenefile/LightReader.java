package org.diacaustic.scenefile;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.diacaustic.light.DirectionalLight;
import org.diacaustic.light.Falloff;
import org.diacaustic.light.FlatLight;
import org.diacaustic.light.Light;
import org.diacaustic.light.PointLight;
import org.diacaustic.light.SphereLight;
import org.diacaustic.light.SpotLight;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;

/** Reads one of the {@code lights}. */
final class LightReader {
    private static final Map<String, Function<MappingReader, Light>> KINDS = new Kinds<Function<MappingReader, Light>>()
            .with("point", LightReader::point)
            .with("spot", LightReader::spot)
            .with("directional", LightReader::directional)
            .with("disc", LightReader::disc)
            .with("rectangle", LightReader::rectangle)
            .with("sphere", LightReader::sphere)
            .map();

    private static final Map<String, Falloff> FALLOFFS = new Kinds<Falloff>()
            .with("inverse-square", new Falloff.InverseSquare())
            .with("none", new Falloff.None())
            .map();

    private static final Map<String, Function<MappingReader, Falloff>> FALLOFF_KINDS = new Kinds<
                    Function<MappingReader, Falloff>>()
            .with("polynomial", LightReader::polynomial)
            .map();

    private LightReader() {}

    static Optional<Light> read(Variant variant) {
        return variant.read(KINDS);
    }

    private static Light point(MappingReader in) {
        Vector3 at = in.vector3("at").required();
        Color intensity = in.color("intensity").atLeast(0).required();
        Falloff falloff = falloff(in);
        double exponent = highlightExponent(in);
        return Building.of(in, () -> new PointLight(at, intensity, falloff, exponent));
    }

    private static Light spot(MappingReader in) {
        Vector3 at = in.vector3("at").required();
        Vector3 direction = in.direction("direction").required();
        double outer =
                in.number("outer-angle").above(0).atMost(180).in("degrees").required();
        double inner =
                in.number("inner-angle").atLeast(0).atMost(180).in("degrees").or(outer);
        Color intensity = in.color("intensity").atLeast(0).required();
        Falloff falloff = falloff(in);
        double exponent = highlightExponent(in);
        return Building.of(in, () -> new SpotLight(at, direction, inner, outer, intensity, falloff, exponent));
    }

    private static Light directional(MappingReader in) {
        Vector3 direction = in.direction("direction").required();
        Color irradiance = in.color("irradiance").atLeast(0).required();
        double exponent = highlightExponent(in);
        return Building.of(in, () -> new DirectionalLight(direction, irradiance, exponent));
    }

    private static Light disc(MappingReader in) {
        Vector3 at = in.vector3("at").required();
        Vector3 normal = in.direction("normal").required();
        double radius = in.number("radius").above(0).required();
        Color radiance = in.color("radiance").atLeast(0).required();
        Falloff falloff = falloff(in);
        int samples = samples(in);
        return Building.of(in, () -> FlatLight.disc(at, normal, radius, radiance, falloff, samples));
    }

    private static Light rectangle(MappingReader in) {
        Vector3 corner = in.vector3("corner").required();
        List<Vector3> edges = in.points("edges", 2).required();
        Color radiance = in.color("radiance").atLeast(0).required();
        Falloff falloff = falloff(in);
        int samples = samples(in);
        if (edges.size() > 2) {
            in.error("edges", "expected 2 edges, found " + edges.size());
        }
        return Building.of(
                in, () -> FlatLight.rectangle(corner, edges.get(0), edges.get(1), radiance, falloff, samples));
    }

    private static Light sphere(MappingReader in) {
        Vector3 at = in.vector3("at").required();
        double radius = in.number("radius").above(0).required();
        Color radiance = in.color("radiance").atLeast(0).required();
        Falloff falloff = falloff(in);
        int samples = samples(in);
        return Building.of(in, () -> new SphereLight(at, radius, radiance, falloff, samples));
    }

    private static Falloff falloff(MappingReader in) {
        if (in.form("falloff") != Form.MAPPING) {
            return in.choice("falloff", FALLOFFS).or(new Falloff.InverseSquare());
        }
        return in.variant("falloff").read(FALLOFF_KINDS).orElse(new Falloff.None());
    }

    private static Falloff polynomial(MappingReader in) {
        double constant = in.number("constant").atLeast(0).or(0.0);
        double linear = in.number("linear").atLeast(0).or(0.0);
        double quadratic = in.number("quadratic").atLeast(0).or(0.0);
        return Building.of(in, () -> new Falloff.Polynomial(constant, linear, quadratic));
    }

    private static double highlightExponent(MappingReader in) {
        return in.number("highlight-exponent").atLeast(0).or(0.0);
    }

    private static int samples(MappingReader in) {
        return in.integer("samples").atLeast(1).atMost(1 << 20).or(16);
    }
}
