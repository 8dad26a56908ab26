package org.diacaustic.material;

import org.diacaustic.image.LinearImage;
import org.diacaustic.math.Rgb;
import org.diacaustic.shape.Hit;

/**
 * A height image on a surface: black is low, white is {@code height} scene units above it. The slope is a central
 * difference over one texel, taken to the surface by the tangents of its map; where the map has none (at the poles of a
 * sphere) the surface is flat.
 */
public final class ImageBump implements BumpMap {
    private final ImageSampler sampler;
    private final double height;

    public ImageBump(LinearImage image, double height, int repeatU, int repeatV) {
        if (!Double.isFinite(height)) {
            throw new IllegalArgumentException("the height of a bump must be finite, but is " + height);
        }
        this.sampler = new ImageSampler(image, repeatU, repeatV);
        this.height = height;
    }

    @Override
    public boolean needsMap() {
        return true;
    }

    @Override
    public void addGradient(Hit hit, Gradient gradient) {
        Rgb scratch = gradient.scratch;
        double du = 0.5 / sampler.texelsAcross();
        double dv = 0.5 / sampler.texelsDown();
        double alongU = (brightness(hit.u + du, hit.v, scratch) - brightness(hit.u - du, hit.v, scratch)) / (2 * du);
        double alongV = (brightness(hit.u, hit.v + dv, scratch) - brightness(hit.u, hit.v - dv, scratch)) / (2 * dv);
        // The gradient g in the tangent plane with g·(dp/du) = dh/du and g·(dp/dv) = dh/dv.
        double uu = dot(hit.tangentUX, hit.tangentUY, hit.tangentUZ, hit.tangentUX, hit.tangentUY, hit.tangentUZ);
        double uv = dot(hit.tangentUX, hit.tangentUY, hit.tangentUZ, hit.tangentVX, hit.tangentVY, hit.tangentVZ);
        double vv = dot(hit.tangentVX, hit.tangentVY, hit.tangentVZ, hit.tangentVX, hit.tangentVY, hit.tangentVZ);
        double determinant = uu * vv - uv * uv;
        if (!(determinant > 0)) {
            return;
        }
        double a = height * (alongU * vv - alongV * uv) / determinant;
        double b = height * (alongV * uu - alongU * uv) / determinant;
        gradient.add(
                a * hit.tangentUX + b * hit.tangentVX,
                a * hit.tangentUY + b * hit.tangentVY,
                a * hit.tangentUZ + b * hit.tangentVZ);
    }

    private double brightness(double u, double v, Rgb scratch) {
        sampler.sample(u, v, scratch);
        return (scratch.red + scratch.green + scratch.blue) / 3;
    }

    private static double dot(double ax, double ay, double az, double bx, double by, double bz) {
        return ax * bx + ay * by + az * bz;
    }
}
