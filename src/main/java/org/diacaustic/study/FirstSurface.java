package org.diacaustic.study;

import org.diacaustic.light.Light;
import org.diacaustic.material.Material;
import org.diacaustic.material.Surface;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Rgb;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.shape.Hit;

/** Finds what an eye ray meets first. Owned by one task. */
final class FirstSurface {
    private final SceneIndex index;
    private final Light[] visibleLights;
    private final Rgb glow = new Rgb();
    private final Surface surface = new Surface();

    /** The ray to aim before {@link #find}. */
    final Ray ray = new Ray();

    /** Where the ray met a surface. */
    final Hit hit = new Hit();

    FirstSurface(Scene scene, SceneIndex index) {
        this.index = index;
        this.visibleLights = scene.lights().stream().filter(Light::isVisible).toArray(Light[]::new);
    }

    /** Follows the ray; returns the number of the object met, or {@link SceneIndex#NONE} for nothing or a lamp. */
    int find() {
        int object = index.nearest(ray, SceneIndex.NONE, Ray.FREE);
        if (object == SceneIndex.NONE) {
            return object;
        }
        hit.take(ray);
        ray.leaving = Ray.FREE;
        for (Light light : visibleLights) {
            if (light.emitsAlong(ray, glow)) {
                return SceneIndex.NONE;
            }
        }
        index.object(object).shape().complete(ray, hit);
        return object;
    }

    /** The cosine between the ray, turned round, and the outward normal: positive in front. */
    double cosine() {
        return -(ray.directionX * hit.normalX + ray.directionY * hit.normalY + ray.directionZ * hit.normalZ);
    }

    /** The fraction of irradiance that leaves the surface in all directions; valid until the next call. */
    Rgb diffuse(int object) {
        Material material = index.object(object).material();
        if (material.needsMap()) {
            index.object(object).shape().inverseMap(hit);
        }
        material.evaluate(hit, surface);
        return surface.diffuse;
    }
}
