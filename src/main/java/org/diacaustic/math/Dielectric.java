package org.diacaustic.math;

/**
 * What a smooth interface between two dielectrics does to light: Snell's law and the unpolarised Fresnel equations
 * [Thesis 2.3, Eq. 2 and 3; Born and Wolf 1999, 1.5]. Mutable and owned by one task; {@link #evaluate} fills it in.
 *
 * <p>Differences that vanish as the two indices approach each other, or the angle its critical value, are factored so
 * that they keep their digits: the reflectance of an index ratio of 1 + 1e-12 is right, and so is the transmittance of a
 * grazing ray. The smaller of the two is computed as itself and the larger is what is left, so that they add up to 1.
 */
public final class Dielectric {
    /** The fraction of the power that is reflected, 0..1; 1 under total internal reflection. */
    public double reflectance;

    /** The fraction of the power that is transmitted, 0..1; 0 under total internal reflection. */
    public double transmittance;

    /** The cosine of the angle of the transmitted ray, 0..1; 0 under total internal reflection. */
    public double cosTransmitted;

    /** Whether there is no transmitted ray. */
    public boolean totalInternalReflection;

    /** nIncident ÷ nTransmitted. */
    public double eta;

    private double cosIncident;

    /**
     * @param cosIncident cosine of the angle of incidence, 0..1, on the side where the light comes from
     * @param nIncident index of refraction on that side
     * @param nTransmitted index of refraction on the other
     */
    public void evaluate(double cosIncident, double nIncident, double nTransmitted) {
        this.cosIncident = cosIncident;
        eta = nIncident / nTransmitted;
        if (nIncident == nTransmitted) {
            cosTransmitted = cosIncident;
            totalInternalReflection = false;
            reflectance = 0;
            transmittance = 1;
            return;
        }
        double difference = nIncident - nTransmitted;
        double sum = nIncident + nTransmitted;
        double incident = nIncident * cosIncident;
        // (nT cosT)² = (nI cosI)² − (nI² − nT²)
        double squared = Arithmetic.differenceOfProducts(incident, incident, difference, sum);
        totalInternalReflection = !(squared > 0);
        if (totalInternalReflection) {
            cosTransmitted = 0;
            reflectance = 1;
            transmittance = 0;
            return;
        }
        double transmitted = Math.sqrt(squared);
        cosTransmitted = Math.min(1, transmitted / nTransmitted);
        double perpendicular = incident + transmitted;
        double parallel = nTransmitted * cosIncident + nIncident * cosTransmitted;
        double flow = 4 * incident * transmitted;
        transmittance = 0.5 * flow * (1 / (perpendicular * perpendicular) + 1 / (parallel * parallel));
        if (transmittance < 0.5) {
            reflectance = 1 - transmittance;
            return;
        }
        double contrast = difference * sum;
        double sinTransmittedSquared = (1 - cosTransmitted) * (1 + cosTransmitted);
        double rs = contrast / (perpendicular * perpendicular);
        double rp = contrast
                * Arithmetic.differenceOfProducts(cosIncident, cosIncident, 1, sinTransmittedSquared)
                / (parallel * parallel);
        reflectance = 0.5 * (rs * rs + rp * rp);
        transmittance = 1 - reflectance;
    }

    /**
     * The coefficient g of the refracted direction η·I + g·N, where N faces against the incident direction I: η cosI −
     * cosT of [Thesis 2.3, Eq. 3], without cancellation. Valid unless {@link #totalInternalReflection}.
     */
    public double normalCoefficient() {
        return (eta - 1) * (eta + 1) / (eta * cosIncident + cosTransmitted);
    }
}
