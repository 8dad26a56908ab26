package org.diacaustic.render;

import org.diacaustic.light.DirectionalLight;
import org.diacaustic.light.PointLight;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.StopSignal;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.MapSettings;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.Shape;

/** One eye ray through a scene that a test puts together, in doubles. */
final class Eye {
    private final Scene.Builder scene = Scene.builder();
    private Settings.Builder settings =
            Settings.physical().toBuilder().minimumThroughput(0).maxDepth(200);
    private Counters counters;

    Eye object(Shape shape, Material.Builder material) {
        scene.object("object", shape, material.build());
        return this;
    }

    Eye glass(Shape shape, double indexOfRefraction) {
        return object(shape, clear(indexOfRefraction));
    }

    Eye light(Vector3 position, double intensity) {
        scene.light(new PointLight(position, Color.grey(intensity)));
        return this;
    }

    Eye sun(Vector3 direction, double irradiance, double highlightExponent) {
        scene.light(new DirectionalLight(direction, Color.grey(irradiance), highlightExponent));
        return this;
    }

    Eye background(double radiance) {
        scene.background(Color.grey(radiance));
        return this;
    }

    Scene.Builder scene() {
        return scene;
    }

    Settings.Builder settings() {
        return settings;
    }

    Eye settings(Settings.Builder other) {
        settings = other;
        return this;
    }

    Counters counters() {
        return counters;
    }

    /** The radiance that arrives at a point, from the direction in which the eye looks. */
    Color sees(Vector3 from, Vector3 direction) {
        Vector3 up = Math.abs(direction.normalized().y()) < 0.9 ? Vector3.UNIT_Y : Vector3.UNIT_X;
        Camera camera = Camera.builder()
                .from(from)
                .to(from.plus(direction))
                .up(up)
                .size(1, 1)
                .build();
        EyeTracer tracer = new EyeTracer(
                RenderPlan.of(scene.camera(camera).build(), withoutMap(settings).build()), Illumination.NONE, false);
        tracer.random().start(1, 0, 0);
        tracer.ray().set(from, direction.normalized());
        Color radiance = tracer.trace(new StopSignal()).toColor();
        counters = tracer.counters();
        return radiance;
    }

    /** Eye rays alone: what glass does to light from lamps is the business of other tests. */
    static Settings.Builder withoutMap(Settings.Builder settings) {
        return settings.maps(MapSettings.builder().map(MapName.NONE).build());
    }

    static Material.Builder clear(double indexOfRefraction) {
        return clear(new Medium(indexOfRefraction, Color.BLACK, 0));
    }

    static Material.Builder clear(Medium medium) {
        return Material.builder().transparency(Color.WHITE).inside(medium);
    }

    static Material.Builder matt(double diffuse) {
        return Material.builder().diffuse(Color.grey(diffuse));
    }

    static Material.Builder mirror(double reflectivity) {
        return Material.builder().reflectivity(Color.grey(reflectivity));
    }

    static Vector3 v(double x, double y, double z) {
        return new Vector3(x, y, z);
    }
}
