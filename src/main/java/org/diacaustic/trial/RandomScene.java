package org.diacaustic.trial;

import org.diacaustic.light.DirectionalLight;
import org.diacaustic.light.Falloff;
import org.diacaustic.light.PointLight;
import org.diacaustic.light.SpotLight;
import org.diacaustic.material.Material;
import org.diacaustic.material.Medium;
import org.diacaustic.material.Ripple;
import org.diacaustic.material.Wave;
import org.diacaustic.math.Color;
import org.diacaustic.math.SampleStream;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Scene;
import org.diacaustic.shape.ConvexPolygon;
import org.diacaustic.shape.Plane;
import org.diacaustic.shape.Shape;

/**
 * A scene of chance, the same for the same seed, that can be built at any place and scale: a matt floor, up to seven objects
 * of all kinds, which may overlap, of stone, mirror, glass and water, under up to three lights.
 */
final class RandomScene {
    private static final int MOST_OBJECTS = 7;
    private static final int MOST_LIGHTS = 3;

    private final long seed;
    private final int pixels;
    private final boolean isEndless;

    /**
     * @param pixels of each side of its picture
     * @param isEndless whether the floor has no end
     */
    RandomScene(long seed, int pixels, boolean isEndless) {
        this.seed = seed;
        this.pixels = pixels;
        this.isEndless = isEndless;
    }

    /** @param brightness a factor of all lights */
    Scene build(Placing placing, Falloff falloff, double brightness) {
        Chance chance = new Chance(seed);
        RandomShapes shapes = new RandomShapes(chance, placing);
        Scene.Builder scene = Scene.builder().camera(camera(chance, placing));
        int lights = chance.upTo(MOST_LIGHTS);
        for (int i = 0; i < lights; i++) {
            addLight(scene, chance, placing, falloff, brightness);
        }
        scene.object("floor", floor(placing), matt(chance));
        if (chance.of(0.3)) {
            scene.object("water", square(4, chance.in(0.2, 1.5), placing), water(chance, placing));
        }
        int objects = chance.upTo(MOST_OBJECTS);
        for (int i = 0; i < objects; i++) {
            scene.object("object " + i, shapes.next(), material(chance, placing));
        }
        return scene.build();
    }

    private Camera camera(Chance chance, Placing placing) {
        return Camera.builder()
                .from(placing.point(chance.in(-5, 5), chance.in(1, 6), chance.in(6, 9)))
                .to(placing.point(chance.in(-1, 1), chance.in(0, 1.5), chance.in(-1, 1)))
                .fieldOfView(chance.in(25, 50))
                .size(pixels, pixels)
                .build();
    }

    private static void addLight(
            Scene.Builder scene, Chance chance, Placing placing, Falloff falloff, double brightness) {
        Vector3 at = placing.point(chance.in(-4, 4), chance.in(4, 9), chance.in(-4, 4));
        Color intensity = chance.color(0.2, 1).times(brightness);
        int kind = chance.below(3);
        if (kind == 0) {
            scene.light(new PointLight(at, intensity, falloff, chance.of(0.5) ? 40 : 0));
        } else if (kind == 1) {
            Vector3 down = new Vector3(chance.in(-0.5, 0.5), -1, chance.in(-0.5, 0.5));
            scene.light(new SpotLight(at, down, chance.in(5, 20), chance.in(25, 60), intensity, falloff, 0));
        } else if (falloff instanceof Falloff.None) {
            // A distant light has no falloff, so its brightness does not go along with a scene's size.
            scene.light(
                    new DirectionalLight(new Vector3(chance.in(-1, 1), -1, chance.in(-1, 1)), chance.color(0.2, 1), 0));
        } else {
            scene.light(new PointLight(at, intensity, falloff, 0));
        }
    }

    private Shape floor(Placing placing) {
        return isEndless ? new Plane(placing.point(0, 0, 0), Vector3.UNIT_Y) : square(12, 0, placing);
    }

    /** A horizontal square about the vertical axis, facing up. */
    private static ConvexPolygon square(double half, double height, Placing placing) {
        return ConvexPolygon.twoSided(
                placing.point(-half, height, -half),
                placing.point(-half, height, half),
                placing.point(half, height, half),
                placing.point(half, height, -half));
    }

    private static Material material(Chance chance, Placing placing) {
        return switch (chance.below(5)) {
            case 0 -> matt(chance);
            case 1 -> mirror(chance);
            case 2 -> water(chance, placing);
            default -> glass(chance, placing);
        };
    }

    private static Material matt(Chance chance) {
        return Material.builder().diffuse(chance.color(0.2, 0.9)).build();
    }

    private static Material mirror(Chance chance) {
        return Material.builder()
                .diffuse(chance.color(0, 0.3))
                .reflectivity(chance.color(0.3, 0.7))
                .build();
    }

    private static Material glass(Chance chance, Placing placing) {
        Color absorption = chance.of(0.5) ? chance.color(0, 1) : Color.BLACK;
        return Material.builder()
                .transparency(chance.color(0.8, 1))
                .inside(new Medium(chance.in(1.05, 2.4), absorption.times(placing.perLength(1)), chance.below(3)))
                .build();
    }

    private static Material water(Chance chance, Placing placing) {
        Vector3 direction = new Vector3(chance.in(-1, 1), 0, chance.in(-1, 1)).normalized();
        double waveNumber = chance.in(2, 12);
        double slope = chance.in(0.02, 0.3);
        Wave wave = new Wave(
                direction,
                placing.perLength(waveNumber),
                placing.length(slope / waveNumber),
                placing.phase(chance.in(0, 6), waveNumber, direction));
        Ripple ripple = new Ripple(
                placing.point(chance.in(-2, 2), 0, chance.in(-2, 2)),
                placing.perLength(9),
                placing.length(0.01),
                chance.in(0, 6),
                placing.length(2));
        return Material.builder()
                .transparency(chance.color(0.9, 1))
                .inside(new Medium(1.33, Color.grey(placing.perLength(0.05)), 1))
                .bump(wave)
                .bump(ripple)
                .build();
    }

    /** Random numbers, named. */
    static final class Chance {
        private final SampleStream random = new SampleStream();

        Chance(long seed) {
            random.start(seed, 0, 0);
        }

        double in(double low, double high) {
            return low + (high - low) * random.nextDouble();
        }

        /** 0 to count − 1. */
        int below(int count) {
            return (int) (count * random.nextDouble());
        }

        /** 1 to count. */
        int upTo(int count) {
            return 1 + below(count);
        }

        boolean of(double chance) {
            return random.nextDouble() < chance;
        }

        Color color(double low, double high) {
            return new Color(in(low, high), in(low, high), in(low, high));
        }

        Vector3 direction() {
            double z = in(-1, 1);
            double angle = in(0, 2 * Math.PI);
            double r = Math.sqrt(1 - z * z);
            return new Vector3(r * StrictMath.cos(angle), r * StrictMath.sin(angle), z);
        }
    }
}
