package org.diacaustic.preprocess;

import java.util.List;
import java.util.function.UnaryOperator;
import org.diacaustic.light.Falloff;
import org.diacaustic.light.Light;
import org.diacaustic.light.PointLight;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.material.Wave;
import org.diacaustic.math.Color;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.EstimatorName;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MapName;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.Settings;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Shape;
import org.diacaustic.shape.Sphere;

/** Builds small scenes and runs forward passes over them. */
final class Forward {
    static final Material MATT = Material.builder().diffuse(Color.WHITE).build();

    private Forward() {}

    static Material clear(double indexOfRefraction, double transparency) {
        return Material.builder()
                .transparency(Color.grey(transparency))
                .inside(Medium.of(indexOfRefraction))
                .build();
    }

    static Camera camera() {
        return Camera.builder()
                .from(new Vector3(0, 9, -9))
                .to(Vector3.ZERO)
                .size(8, 8)
                .build();
    }

    static Light lamp(Vector3 at, Falloff falloff) {
        return new PointLight(at, Color.WHITE, falloff, 0);
    }

    /** A waved sheet of transparency 0.9 and index 1 at height 4 over an endless floor, under a lamp. */
    static Scene sheetOverFloor(Vector3 lamp, Falloff falloff) {
        return sheetOver(new Plane(Vector3.ZERO, Vector3.UNIT_Y), lamp, falloff);
    }

    /** The same over a floor of its own. */
    static Scene sheetOver(Shape floor, Vector3 lamp, Falloff falloff) {
        Material sheet = Material.builder()
                .transparency(Color.grey(0.9))
                .bump(new Wave(Vector3.UNIT_X, 0.8, 0.03, 0))
                .build();
        return Scene.builder()
                .camera(camera())
                .light(lamp(lamp, falloff))
                .object("floor", floor, MATT)
                .object("sheet", square(4, 2), sheet)
                .build();
    }

    /** A horizontal square about the vertical axis, facing up. */
    static ConvexPolygon square(double height, double half) {
        return ConvexPolygon.twoSided(
                new Vector3(-half, height, -half),
                new Vector3(-half, height, half),
                new Vector3(half, height, half),
                new Vector3(half, height, -half));
    }

    /** A ball of glass and one of matt stone over an endless floor. */
    static Scene ballsOverFloor(Light light) {
        return Scene.builder()
                .camera(camera())
                .light(light)
                .object("floor", new Plane(Vector3.ZERO, Vector3.UNIT_Y), MATT)
                .object("glass", new Sphere(new Vector3(0, 1.5, 0), 1), clear(1.5, 1))
                .object("stone", new Sphere(new Vector3(2, 1, 0.5), 0.7), MATT)
                .build();
    }

    static Settings settings(UnaryOperator<ForwardSettings.Builder> change) {
        return Settings.physical().toBuilder()
                .forward(change.apply(ForwardSettings.builder()).build())
                .build();
    }

    static ForwardPlan plan(Scene scene, Settings settings, String preProcessor, long rays) {
        SceneIndex index = SceneIndex.of(scene.objects(), settings.usesListOrder());
        MapName map = settings.maps().map() == MapName.AUTO
                ? MapName.PHOTON_MAP
                : settings.maps().map();
        EstimatorName estimator = settings.maps().estimator() == EstimatorName.AUTO
                ? EstimatorName.DENSITY
                : settings.maps().estimator();
        return new ForwardPlanner(scene, index, settings)
                .plan(PreProcessors.byName(List.of()).get(preProcessor), rays, map, estimator);
    }

    static ForwardPass run(Scene scene, Settings settings, String preProcessor, long rays) {
        ForwardPass pass = new ForwardPass(plan(scene, settings, preProcessor, rays), 0, new Workers(2));
        pass.run();
        return pass;
    }
}
