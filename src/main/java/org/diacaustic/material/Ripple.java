package org.diacaustic.material;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Hit;

/**
 * A round wave about a centre: height · exp(−r ÷ reach) · sin(waveNumber · r + phase), where r is the distance from the
 * centre. At the centre itself it is flat.
 *
 * @param centre in scene coordinates
 * @param waveNumber 2π ÷ length of a wave, in 1 ÷ scene unit
 * @param height of the first crests, in scene units
 * @param phase in radians
 * @param reach the distance over which the height falls to 1/e; infinite for a ripple that does not fall
 */
public record Ripple(Vector3 centre, double waveNumber, double height, double phase, double reach) implements BumpMap {
    public Ripple {
        if (!(waveNumber > 0 && waveNumber < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("a wave number must be positive and finite, but is " + waveNumber);
        }
        if (!(reach > 0)) {
            throw new IllegalArgumentException("the reach of a ripple must be positive, but is " + reach);
        }
        if (!Double.isFinite(height) || !Double.isFinite(phase)) {
            throw new IllegalArgumentException(
                    "height and phase of a ripple must be finite, but are " + height + " and " + phase);
        }
    }

    @Override
    public void addGradient(Hit hit, Gradient gradient) {
        double x = hit.x - centre.x();
        double y = hit.y - centre.y();
        double z = hit.z - centre.z();
        double r = Arithmetic.length(x, y, z);
        if (r == 0) {
            return;
        }
        double angle = waveNumber * r + phase;
        double decay = height * StrictMath.exp(-r / reach);
        double slope = decay * (waveNumber * StrictMath.cos(angle) - StrictMath.sin(angle) / reach);
        gradient.add(slope * x / r, slope * y / r, slope * z / r);
    }
}
