package org.diacaustic.material;

import org.diacaustic.math.Vector3;
import org.diacaustic.shape.Hit;

/**
 * A straight wave: height · sin(waveNumber · s + phase), where s is the distance along the direction, in scene
 * coordinates. The thesis' waves are sums of these.
 *
 * @param direction in which the wave runs; made a unit vector
 * @param waveNumber 2π ÷ length of a wave, in 1 ÷ scene unit
 * @param height of a crest above the mean, in scene units
 * @param phase in radians
 */
public record Wave(Vector3 direction, double waveNumber, double height, double phase) implements BumpMap {
    public Wave {
        direction = direction.normalized();
        if (!(waveNumber > 0 && waveNumber < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("a wave number must be positive and finite, but is " + waveNumber);
        }
        if (!Double.isFinite(height) || !Double.isFinite(phase)) {
            throw new IllegalArgumentException(
                    "height and phase of a wave must be finite, but are " + height + " and " + phase);
        }
    }

    public static Wave ofLength(Vector3 direction, double length, double height, double phase) {
        return new Wave(direction, 2 * Math.PI / length, height, phase);
    }

    @Override
    public void addGradient(Hit hit, Gradient gradient) {
        double along = direction.x() * hit.x + direction.y() * hit.y + direction.z() * hit.z;
        double slope = height * waveNumber * StrictMath.cos(waveNumber * along + phase);
        gradient.add(slope * direction.x(), slope * direction.y(), slope * direction.z());
    }
}
