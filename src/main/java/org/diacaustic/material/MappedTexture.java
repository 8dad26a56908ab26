package org.diacaustic.material;

import org.diacaustic.math.Rgb;
import org.diacaustic.shape.Hit;
import org.diacaustic.shape.InverseMapping;

/**
 * A texture laid on a surface through an inverse mapping of its own in place of the shape's, which stays as it was for
 * what else is laid on the surface.
 */
public record MappedTexture(Texture texture, InverseMapping mapping) implements Texture {

    @Override
    public void evaluate(Hit hit, Rgb color) {
        double u = hit.u;
        double v = hit.v;
        double ux = hit.tangentUX;
        double uy = hit.tangentUY;
        double uz = hit.tangentUZ;
        double vx = hit.tangentVX;
        double vy = hit.tangentVY;
        double vz = hit.tangentVZ;
        mapping.map(hit);
        texture.evaluate(hit, color);
        hit.setMap(u, v);
        hit.setTangents(ux, uy, uz, vx, vy, vz);
    }
}
