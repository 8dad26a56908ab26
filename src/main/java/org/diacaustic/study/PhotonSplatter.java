package org.diacaustic.study;

import org.diacaustic.map.PhotonStore;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.material.Medium;
import org.diacaustic.math.Color;
import org.diacaustic.math.Rgb;
import org.diacaustic.preprocess.ForwardPlan;
import org.diacaustic.scene.MediumLocator;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.scene.Settings;

/**
 * Puts single photons into the pixel through which the eye sees them directly. A photon is a point of irradiance; what it
 * adds to the mean radiance of its pixel is diffuse/π · power · cosine ÷ distance², per solid angle of the pixel. Summed over
 * photons that is, on average, exactly the picture: there is no map and nothing is smoothed. Owned by one task.
 */
final class PhotonSplatter {
    /** How far from where it should be a photon is found, as a part of the scene: rounding of its single precision. */
    private static final double REACH = 0x1p-20;

    private final PinholeView view;
    private final FirstSurface first;
    private final double extent;
    private final double diffuseFactor;
    private final Color absorption;
    private final SurfacePoint at = new SurfacePoint();

    /** What the photon last put adds to the radiance of its pixel. */
    final Rgb radiance = new Rgb();

    PhotonSplatter(Scene scene, Settings settings, ForwardPlan plan, PinholeView view) {
        this.view = view;
        this.first = new FirstSurface(scene, plan.index());
        this.extent = plan.extent();
        this.diffuseFactor = settings.normalizesDiffuse() ? 1 / Math.PI : 1;
        this.absorption = MediumLocator.locate(plan.index(), scene.camera().from())
                .current()
                .absorption();
    }

    /** Puts photon i; returns the number of its pixel, or −1 if it is not seen directly. */
    int put(PhotonStore photons, int i) {
        photons.position(i, at);
        int pixel = view.aim(at.x, at.y, at.z, first.ray);
        if (pixel < 0) {
            return pixel;
        }
        int object = first.find();
        if (object == SceneIndex.NONE || object != at.object) {
            return -1;
        }
        double cosine = first.cosine();
        double distance = first.hit.t;
        if (cosine > 0 != at.front || !isHere(distance, Math.abs(cosine))) {
            return -1;
        }
        photons.power(i, radiance);
        radiance.multiply(first.diffuse(object));
        radiance.scale(diffuseFactor * Math.abs(cosine) / (distance * distance) * view.pixelsPerSteradian(first.ray));
        radiance.multiply(
                Medium.transmittance(absorption.red(), distance),
                Medium.transmittance(absorption.green(), distance),
                Medium.transmittance(absorption.blue(), distance));
        return pixel;
    }

    /** Tests of a ray against an object or a volume since they were last asked for. */
    long takeTests() {
        long tests = first.ray.tests;
        first.ray.tests = 0;
        return tests;
    }

    /** Whether the ray met the surface where the photon lies, and not another part of the same object. */
    private boolean isHere(double distance, double cosine) {
        double dx = at.x - first.hit.x;
        double dy = at.y - first.hit.y;
        double dz = at.z - first.hit.z;
        double off = Math.sqrt(dx * dx + dy * dy + dz * dz);
        return off * cosine <= REACH * (extent + distance);
    }
}
