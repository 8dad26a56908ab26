package org.diacaustic.material;

/**
 * The rules by which surfaces scatter, with the thesis' ways beside the physical ones.
 *
 * @param fresnel whether interfaces split light by Fresnel's equations; otherwise by the given coefficients alone
 * @param dropTotalInternalReflection whether totally reflected light is lost, as in the thesis, or reflected
 * @param scaleRadiance whether refracted radiance is scaled by (nNear ÷ nFar)², near being the eye's side
 * @param backFacingBump what happens to a bumped normal that faces away from the ray
 */
public record ScatterRules(
        boolean fresnel, boolean dropTotalInternalReflection, boolean scaleRadiance, BackFacingBump backFacingBump) {

    /** Light as it is. */
    public static final ScatterRules PHYSICAL = new ScatterRules(true, false, true, BackFacingBump.BEND);

    /** Light as in the thesis. */
    public static final ScatterRules THESIS = new ScatterRules(false, true, false, BackFacingBump.FLIP);

    /** What happens to a bumped normal that faces away from the ray. */
    public enum BackFacingBump {
        /** It is bent back to the horizon of the ray, so that the picture changes continuously. */
        BEND,
        /** It is turned round, as in the thesis. */
        FLIP
    }
}
