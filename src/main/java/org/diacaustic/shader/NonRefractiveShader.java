package org.diacaustic.shader;

import org.diacaustic.material.Medium;
import org.diacaustic.material.ScatterRules;
import org.diacaustic.math.Dielectric;
import org.diacaustic.math.Rgb;
import org.diacaustic.scene.MediumStack;

/**
 * The non-refractive shading model: opaque objects stop the light, transparent ones filter it in the order in which the
 * light meets them, and nothing bends [Thesis 3.2.2]. It is exact where nothing refracts or mirrors.
 *
 * <p>With Fresnel's equations on, each interface also takes what it would reflect at the angle of the straight line, and
 * with attenuation, absorbing media take their part by distance.
 */
public final class NonRefractiveShader implements Shader {
    public static final String NAME = "non-refractive";

    private final boolean fresnel;
    private final boolean attenuates;

    /** @param attenuates whether interfaces and media take their part; if not, surfaces only filter by their colour */
    public NonRefractiveShader(ScatterRules rules, boolean attenuates) {
        this.fresnel = rules.fresnel() && attenuates;
        this.attenuates = attenuates;
    }

    @Override
    public String name() {
        return NAME;
    }

    @Override
    public boolean transmit(ShadowRay shadow, Rgb transmittance) {
        Crossings crossings = shadow.collector.crossings;
        crossings.clear();
        if (shadow.isStoppedByLastBlocker() || shadow.visit(shadow.collector)) {
            transmittance.set(0, 0, 0);
            return false;
        }
        transmittance.set(1, 1, 1);
        if (attenuates) {
            attenuate(shadow, crossings, transmittance);
        }
        // The last crossing from the lit point is the first that the light meets.
        for (int i = crossings.count() - 1; i >= 0; i--) {
            transmittance.multiply(crossings.red(i), crossings.green(i), crossings.blue(i));
        }
        return !transmittance.isBlack();
    }

    /** Takes what the media absorb, and lessens each crossing by what its interface reflects. */
    private void attenuate(ShadowRay shadow, Crossings crossings, Rgb transmittance) {
        MediumStack media = shadow.media;
        double from = 0;
        for (int i = 0; i < crossings.count(); i++) {
            absorb(media.current(), Math.max(0, crossings.distance(i) - from), transmittance);
            from = crossings.distance(i);
            int object = crossings.object(i);
            boolean entering = crossings.isEntering(i);
            media.lookAt(object, entering);
            if (!media.isVisible()) {
                crossings.open(i);
            } else if (fresnel) {
                double n1 = media.near().indexOfRefraction();
                double n2 = media.far().indexOfRefraction();
                crossings.scale(i, straightTransmittance(shadow.dielectric, crossings.cosine(i), n1, n2));
            }
            media.cross(object, entering);
        }
        absorb(media.current(), shadow.ray.tMax - from, transmittance);
    }

    private void absorb(Medium medium, double distance, Rgb transmittance) {
        if (attenuates && medium.absorbs()) {
            transmittance.multiply(
                    Medium.transmittance(medium.absorption().red(), distance),
                    Medium.transmittance(medium.absorption().green(), distance),
                    Medium.transmittance(medium.absorption().blue(), distance));
        }
    }

    /**
     * What an interface lets through of light that is taken not to bend: as seen from the thinner side, since the line
     * has the angle that light has outside, and light that came in can leave.
     */
    private static double straightTransmittance(Dielectric dielectric, double cosine, double n1, double n2) {
        dielectric.evaluate(cosine, Math.min(n1, n2), Math.max(n1, n2));
        return dielectric.transmittance;
    }
}
