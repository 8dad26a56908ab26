package org.diacaustic.render;

import org.diacaustic.image.LinearImage;
import org.diacaustic.light.Falloff;
import org.diacaustic.light.FlatLight;
import org.diacaustic.light.PointLight;
import org.diacaustic.light.SphereLight;
import org.diacaustic.light.SpotLight;
import org.diacaustic.material.BumpMap;
import org.diacaustic.material.ImageTexture;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.material.Pattern;
import org.diacaustic.material.PatternTexture;
import org.diacaustic.material.Ripple;
import org.diacaustic.material.Wave;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Color;
import org.diacaustic.math.Transform;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Scene;
import org.diacaustic.shape.Box;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Ellipsoid;
import org.diacaustic.shape.FlakeKind;
import org.diacaustic.shape.Frustum;
import org.diacaustic.shape.MeshData;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Quadric;
import org.diacaustic.shape.Sphere;
import org.diacaustic.shape.Sphereflake;
import org.diacaustic.shape.Torus;
import org.diacaustic.shape.Transformed;
import org.diacaustic.shape.TriangleMesh;

/** A scene with one of everything, at any scale: every length times the same factor. */
final class Showcase {
    private final double scale;

    Showcase(double scale) {
        this.scale = scale;
    }

    /** The objects under point lights of the given falloff. */
    Scene.Builder scene(Falloff falloff) {
        return objects()
                .camera(camera().build())
                .background(new Color(0.1, 0.2, 0.3))
                .light(new PointLight(at(3, 9, 4), new Color(60, 50, 40), falloff, 30))
                .light(new SpotLight(at(-4, 6, 3), v(4, -6, -3), 20, 35, Color.grey(30), falloff, 0));
    }

    /** The same with area lights and a lens. */
    Scene.Builder sceneWithAreas() {
        Falloff square = new Falloff.InverseSquare();
        return objects()
                .camera(camera().lens(0.1 * scale, 9 * scale).build())
                .light(FlatLight.disc(at(3, 9, 4), v(-3, -9, -4), scale, Color.grey(20), square, 5))
                .light(new SphereLight(at(-4, 6, 3), 0.5 * scale, Color.grey(30), square, 3));
    }

    private Camera.Builder camera() {
        return Camera.builder()
                .from(at(0.5, 4, 9))
                .to(at(0, 0.8, 0))
                .fieldOfView(42)
                .size(40, 30);
    }

    private Scene.Builder objects() {
        Material.Builder glass = clear(new Medium(1.5, new Color(0.3, 0.1, 0.2).times(1 / scale), 2));
        Material.Builder water = clear(new Medium(1.33, new Color(0.2, 0.1, 0.05).times(1 / scale), 1))
                .bump(wave(v(1, 0, 2), 0.7, 0.02))
                .bump(new Ripple(at(1, 0, 1), 9 / scale, 0.02 * scale, 0.3, 2 * scale));
        Material.Builder brass =
                Material.builder().diffuse(new Color(0.3, 0.2, 0.1)).reflectivity(new Color(0.5, 0.4, 0.2));
        LinearImage stripes = new LinearImage(4, 4);
        for (int i = 0; i < 16; i++) {
            stripes.set(i % 4, i / 4, 0.05 * i, 0.5, 0.9 - 0.05 * i);
        }
        Material.Builder painted = Material.builder().diffuse(new ImageTexture(stripes, 2, 2));
        Material.Builder marble = Material.builder()
                .diffuse(new PatternTexture(
                        new Pattern.Marble(0.8 * scale, 2), Color.grey(0.9), new Color(0.2, 0.1, 0.1)));
        Material.Builder checker = Material.builder()
                .diffuse(new PatternTexture(new Pattern.Checker(0.75 * scale), Color.grey(0.8), Color.grey(0.2)));

        Bounds clip = new Bounds(1.2 * scale, 0, -2.5 * scale, 2.8 * scale, 1.5 * scale, -0.9 * scale);
        // (x − 2)² + (z + 1.7)² = y / 3, a bowl.
        Quadric bowl = Quadric.of(1, 0, 0, -2 * scale, 0, 0, -scale / 6, 1, 1.7 * scale, 6.89 * scale * scale)
                .within(clip);
        return Scene.builder()
                .object("floor", new Plane(at(0, -0.5, 0), Vector3.UNIT_Y), checker.build())
                .object("pool", water(), water.build())
                .object("ball", new Sphere(at(-1.8, 0.9, 0.5), 0.8 * scale), glass.build())
                .object("egg", new Ellipsoid(at(0.2, 0.7, 1.4), at(0.5, 0.7, 0.4)), painted.build())
                .object("ring", new Torus(at(1.9, 0.4, 1), v(0.2, 1, 0.1), 0.7 * scale, 0.25 * scale), brass.build())
                .object("crate", crate(), marble.build())
                .object("drum", Frustum.cylinder(at(-3, 0, -1), at(-3, 1.5, -1.2), 0.5 * scale, true), brass.build())
                .object("bowl", bowl, painted.build())
                .object("pyramid", pyramid(), marble.build())
                .object("flake", flake(), brass.build());
    }

    private ConvexPolygon water() {
        return ConvexPolygon.twoSided(at(-4, 0, -4), at(-4, 0, 4), at(4, 0, 4), at(4, 0, -4));
    }

    private Transformed crate() {
        return new Transformed(
                new Box(at(-0.4, -0.4, -0.4), at(0.4, 0.4, 0.4)),
                Transform.identity().rotate(v(1, 2, 3), 33).translate(at(0.3, 1.2, -1)));
    }

    private TriangleMesh pyramid() {
        double[] vertices = {-1, 0, -3, 0, 0, -1.8, 0.9, 0, -3.1, 0, 1.6, -2.6};
        for (int i = 0; i < vertices.length; i++) {
            vertices[i] *= scale;
        }
        return new TriangleMesh(
                new MeshData(vertices, new int[] {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}, null, null), false);
    }

    private Sphereflake flake() {
        return new Sphereflake(
                FlakeKind.CLASSIC, 2, at(-1, 2.6, -1), 0.5 * scale, 1.0 / 3, Vector3.UNIT_Y, Vector3.UNIT_X);
    }

    private BumpMap wave(Vector3 direction, double length, double height) {
        return Wave.ofLength(direction, length * scale, height * scale, 0.4);
    }

    private Vector3 at(double x, double y, double z) {
        return new Vector3(x, y, z).times(scale);
    }

    private static Material.Builder clear(Medium medium) {
        return Material.builder().transparency(Color.WHITE).inside(medium);
    }

    private static Vector3 v(double x, double y, double z) {
        return new Vector3(x, y, z);
    }
}
