package org.diacaustic.material;

import java.util.ArrayList;
import java.util.List;
import org.diacaustic.math.Color;
import org.diacaustic.shape.Hit;

/** What a surface is made of. Immutable; made by a {@link Builder}. */
public final class Material {
    private final Texture diffuse;
    private final Texture ambient;
    private final Texture reflectivity;
    private final Texture transparency;
    private final Medium inside;
    private final Medium outside;
    private final List<BumpMap> bumps;
    private final boolean needsMap;

    private Material(Builder builder) {
        diffuse = builder.diffuse;
        ambient = builder.ambient;
        reflectivity = builder.reflectivity;
        transparency = builder.transparency;
        inside = builder.inside;
        outside = builder.outside;
        bumps = List.copyOf(builder.bumps);
        needsMap = diffuse.needsMap()
                || ambient.needsMap()
                || reflectivity.needsMap()
                || transparency.needsMap()
                || bumps.stream().anyMatch(BumpMap::needsMap);
    }

    public static Builder builder() {
        return new Builder();
    }

    /** Fills in the coefficients at a completed hit and tilts its shading normal. */
    public void evaluate(Hit hit, Surface surface) {
        diffuse.evaluate(hit, surface.diffuse);
        ambient.evaluate(hit, surface.ambient);
        reflectivity.evaluate(hit, surface.reflectivity);
        transparency.evaluate(hit, surface.transparency);
        if (!bumps.isEmpty()) {
            BumpMap.Gradient gradient = surface.clearedGradient();
            for (int i = 0; i < bumps.size(); i++) {
                bumps.get(i).addGradient(hit, gradient);
            }
            gradient.tilt(hit);
        }
    }

    /** Whether the shape's map coordinates must be set before {@link #evaluate}. */
    public boolean needsMap() {
        return needsMap;
    }

    /** Whether any light leaves the surface in all directions. */
    public boolean isDiffuse() {
        return !isBlack(diffuse);
    }

    /** Whether any light passes through the surface. */
    public boolean isTransparent() {
        return !isBlack(transparency);
    }

    /** Whether the surface mirrors, besides what Fresnel reflects of a transparent one. */
    public boolean isReflective() {
        return !isBlack(reflectivity);
    }

    public boolean isBumped() {
        return !bumps.isEmpty();
    }

    /** The same material on a surface whose normal points the other way. */
    public Material withSidesExchanged() {
        Builder builder = new Builder();
        builder.diffuse = diffuse;
        builder.ambient = ambient;
        builder.reflectivity = reflectivity;
        builder.transparency = transparency;
        builder.inside = outside;
        builder.outside = inside;
        builder.bumps.addAll(bumps);
        return builder.build();
    }

    private static boolean isBlack(Texture texture) {
        return texture instanceof ConstantTexture constant && constant.color().isBlack();
    }

    /** The medium behind the surface, where its outward normal does not point. */
    public Medium inside() {
        return inside;
    }

    /** The medium in front of an open surface; a closed one lies in whatever surrounds it. */
    public Medium outside() {
        return outside;
    }

    /** The largest sum of diffuse, reflectivity and transparency in a channel, as far as they are constant. */
    public double largestConstantSum() {
        Color sum = Color.BLACK;
        for (Texture texture : List.of(diffuse, reflectivity, transparency)) {
            if (texture instanceof ConstantTexture constant) {
                sum = sum.plus(constant.color());
            }
        }
        return sum.largest();
    }

    /** Collects the parts of a material; what is not set is black, in empty space. */
    public static final class Builder {
        private Texture diffuse = ConstantTexture.BLACK;
        private Texture ambient = ConstantTexture.BLACK;
        private Texture reflectivity = ConstantTexture.BLACK;
        private Texture transparency = ConstantTexture.BLACK;
        private Medium inside = Medium.VACUUM;
        private Medium outside = Medium.VACUUM;
        private final List<BumpMap> bumps = new ArrayList<>();

        private Builder() {}

        /** @param texture fraction of irradiance that leaves in all directions */
        public Builder diffuse(Texture texture) {
            diffuse = checkedFraction(texture, "diffuse");
            return this;
        }

        public Builder diffuse(Color color) {
            return diffuse(new ConstantTexture(color));
        }

        /** @param texture constant ambient irradiance in W·m⁻² */
        public Builder ambient(Texture texture) {
            ambient = texture;
            return this;
        }

        /** @param texture fraction mirrored */
        public Builder reflectivity(Texture texture) {
            reflectivity = checkedFraction(texture, "reflectivity");
            return this;
        }

        public Builder reflectivity(Color color) {
            return reflectivity(new ConstantTexture(color));
        }

        /** @param texture fraction let through */
        public Builder transparency(Texture texture) {
            transparency = checkedFraction(texture, "transparency");
            return this;
        }

        public Builder transparency(Color color) {
            return transparency(new ConstantTexture(color));
        }

        public Builder inside(Medium medium) {
            inside = medium;
            return this;
        }

        public Builder outside(Medium medium) {
            outside = medium;
            return this;
        }

        public Builder bump(BumpMap bump) {
            bumps.add(bump);
            return this;
        }

        /** @throws IllegalArgumentException if more light would be mirrored and let through than arrives */
        public Material build() {
            if (reflectivity instanceof ConstantTexture r && transparency instanceof ConstantTexture t) {
                double sum = r.color().plus(t.color()).largest();
                if (sum > 1) {
                    throw new IllegalArgumentException(
                            "reflectivity and transparency must not exceed 1 together, but make " + sum);
                }
            }
            return new Material(this);
        }

        private static Texture checkedFraction(Texture texture, String what) {
            if (texture instanceof ConstantTexture constant
                    && !(constant.color().isFinite()
                            && constant.color().smallest() >= 0
                            && constant.color().largest() <= 1)) {
                throw new IllegalArgumentException(what + " must lie within 0 and 1, but is " + constant.color());
            }
            return texture;
        }
    }
}
