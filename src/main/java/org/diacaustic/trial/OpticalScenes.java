package org.diacaustic.trial;

import org.diacaustic.light.DirectionalLight;
import org.diacaustic.light.Light;
import org.diacaustic.light.PointLight;
import org.diacaustic.map.Kernel;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Shape;

/** What scenes of trials are made of: a light above, an optical element below it, and a matt floor, object 0, that faces up. */
final class OpticalScenes {
    /** Keeps nothing, in all directions alike: it shows the irradiance. */
    static final Material MATT = Material.builder().diffuse(Color.WHITE).build();

    private OpticalScenes() {}

    /** Lets all light through that Fresnel's equations do. */
    static Material clear(double indexOfRefraction) {
        return clear(indexOfRefraction, 0);
    }

    /** @param absorption per scene unit */
    static Material clear(double indexOfRefraction, double absorption) {
        return Material.builder()
                .transparency(Color.WHITE)
                .inside(new Medium(indexOfRefraction, Color.grey(absorption), 0))
                .build();
    }

    static Material mirror(double reflectivity) {
        return Material.builder().reflectivity(Color.grey(reflectivity)).build();
    }

    /** A horizontal square about the vertical axis, facing up. */
    static ConvexPolygon square(double height, double half) {
        return ConvexPolygon.twoSided(
                new Vector3(-half, height, -half),
                new Vector3(-half, height, half),
                new Vector3(half, height, half),
                new Vector3(half, height, -half));
    }

    static Plane level(double height) {
        return new Plane(new Vector3(0, height, 0), Vector3.UNIT_Y);
    }

    /** A lamp on the vertical axis. */
    static Light lamp(double height, double flux) {
        return new PointLight(new Vector3(0, height, 0), Color.grey(flux / (4 * Math.PI)));
    }

    /** Parallel light from above, of irradiance 1. */
    static Light sun() {
        return new DirectionalLight(Vector3.UNIT_Y.negated(), Color.WHITE, 0);
    }

    /** Looks straight down from a height at a point x of a floor. */
    static Camera above(double x, double height, double floor) {
        return Camera.builder()
                .from(new Vector3(x, height, 0))
                .to(new Vector3(x, floor, 0))
                .up(Vector3.UNIT_X)
                .size(1, 1)
                .build();
    }

    static Scene overFloor(Camera camera, Light light, double floor, Shape shape, Material material) {
        return Scene.builder()
                .camera(camera)
                .light(light)
                .object("floor", level(floor), MATT)
                .object("element", shape, material)
                .build();
    }

    /** Light that was refracted so often, and never mirrored. */
    static Settings through(int surfaces, boolean fresnel) {
        return settings(surfaces, false, fresnel);
    }

    /** Light is followed until it has been mirrored or refracted so often, however weak it is. */
    static Settings settings(int depth, boolean followsReflections, boolean fresnel) {
        return Settings.physical().toBuilder()
                .forward(ForwardSettings.builder()
                        .maxDepth(depth)
                        .followReflections(followsReflections)
                        .build())
                .maxDepth(depth)
                .minimumThroughput(0)
                .fresnel(fresnel)
                .build();
    }

    /** Photons within a radius count alike. */
    static Settings gathering(Settings settings, double radius, long seed) {
        return settings.toBuilder()
                .maps(MapSettings.builder()
                        .kernel(Kernel.CONSTANT)
                        .estimator(EstimatorName.DENSITY)
                        .gatherRadius(radius)
                        .build())
                .seed(seed)
                .build();
    }

    /** No light is traced forward: what the eye sees then is direct light. */
    static Settings direct(Settings settings) {
        return settings.toBuilder()
                .forward(ForwardSettings.builder().preProcessor(Settings.NONE).build())
                .build();
    }
}
