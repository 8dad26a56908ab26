package org.diacaustic.trial;

import org.diacaustic.material.ScatterRules;
import org.diacaustic.material.Scattering;
import org.diacaustic.material.Surface;
import org.diacaustic.material.TransportMode;
import org.diacaustic.math.Dielectric;
import org.diacaustic.math.Ray;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.Plane;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Snell's law and Fresnel's equations. */
final class RefractionTrials {
    /** R + T may differ from 1 by this much, which is 4 units in the last place. */
    private static final double ROUNDING = 4 * Math.ulp(1.0);

    /** Cosines at which reflectance is asked for a mean over the hemisphere. */
    private static final int QUADRATURE = 1 << 20;

    private RefractionTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "fresnel_scalar",
                "The Dielectric that every interface of a render asks. R + T must be 1 within 4 units in the last place.",
                RefractionTrials::fresnel);
        operations.add(
                "refract_vector",
                "Scattering, at a completed hit on a Plane with that normal; the ray is in n1 on whichever side it comes from. The"
                        + " direction must have length 1 within the tolerance for lengths.",
                RefractionTrials::vector);
        operations.add(
                "diffuse_fresnel",
                "The mean reflectance, weighted by the cosine, of the Dielectric asked at 2^20 evenly spaced cosines, from outside and"
                        + " from inside; within the tolerance for quadratures.",
                RefractionTrials::hemisphere);
    }

    private static void fresnel(NumericCase asked, Checks checks) {
        Dielectric interfaceOfTwo = new Dielectric();
        interfaceOfTwo.evaluate(
                asked.inputs().number("cosI"),
                asked.inputs().number("n1"),
                asked.inputs().number("n2"));
        checks.number("R + T", 1, interfaceOfTwo.reflectance + interfaceOfTwo.transmittance, ROUNDING);
        checks.same("tir", asked.expected().flag("tir"), interfaceOfTwo.totalInternalReflection);
        checks.number("R", interfaceOfTwo.reflectance);
        checks.number("T", interfaceOfTwo.transmittance);
        if (asked.expected().has("cosT")) {
            checks.number("cosT", interfaceOfTwo.cosTransmitted);
        }
    }

    private static void vector(NumericCase asked, Checks checks) {
        Vector3 incident = RootTrials.vector(asked.inputs(), "I").normalized();
        Plane plane = new Plane(Vector3.ZERO, RootTrials.vector(asked.inputs(), "N"));
        Ray ray = new Ray();
        ray.set(incident.negated(), incident);
        ray.hit(1, 0);
        Hit hit = new Hit();
        hit.take(ray);
        plane.complete(ray, hit);
        int side = incident.dot(plane.normal()) < 0 ? 1 : -1;
        Surface surface = new Surface();
        surface.transparency.set(1, 1, 1);
        Scattering scattering = new Scattering();
        scattering.evaluate(
                ScatterRules.PHYSICAL,
                TransportMode.FLUX,
                ray,
                hit,
                surface,
                side,
                asked.inputs().number("n1"),
                asked.inputs().number("n2"));
        checks.same("tir", asked.expected().flag("tir"), scattering.totalInternalReflection);
        if (!asked.expected().has("T")) {
            checks.holds("nothing is transmitted", scattering.transmittance.isBlack());
            return;
        }
        double[] transmitted = {scattering.transmittedX, scattering.transmittedY, scattering.transmittedZ};
        checks.numbers("T", transmitted, "T");
        double length = Math.hypot(Math.hypot(transmitted[0], transmitted[1]), transmitted[2]);
        checks.number("length", 1, length, asked.tolerance().number("length_abs", ROUNDING));
    }

    private static void hemisphere(NumericCase asked, Checks checks) {
        double index = asked.inputs().number("n");
        double tolerance = asked.tolerance().number("abs_quadrature");
        checks.number("external", asked.expected().number("external"), meanReflectance(1, index), tolerance);
        checks.number("internal", asked.expected().number("internal"), meanReflectance(index, 1), tolerance);
    }

    private static double meanReflectance(double nIncident, double nTransmitted) {
        Dielectric dielectric = new Dielectric();
        double sum = 0;
        for (int i = 0; i < QUADRATURE; i++) {
            double cosine = (i + 0.5) / QUADRATURE;
            dielectric.evaluate(cosine, nIncident, nTransmitted);
            sum += 2 * cosine * dielectric.reflectance;
        }
        return sum / QUADRATURE;
    }
}
