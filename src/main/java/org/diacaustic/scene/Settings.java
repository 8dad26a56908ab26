package org.diacaustic.scene;

import org.diacaustic.material.ScatterRules;

/**
 * How a scene is to be rendered: names and numbers only, nothing resolved. Immutable. {@link #physical()} and {@link
 * #thesis()} are where to start; {@link #toBuilder()} changes what differs.
 */
public final class Settings {
    /** The name that leaves a choice to the plan. */
    public static final String AUTO = "auto";

    /** The name that leaves a part out. */
    public static final String NONE = "none";

    private final Builder values;

    private Settings(Builder values) {
        this.values = values;
    }

    /** Light as it is: what is rendered if nothing else is said. */
    public static Settings physical() {
        return new Builder().build();
    }

    /** Light as in the thesis, for its figures and tables. */
    public static Settings thesis() {
        return new Builder().thesis().build();
    }

    public Builder toBuilder() {
        return new Builder(values);
    }

    /** Name of the shading model, or {@link #AUTO}. */
    public String shader() {
        return values.shader;
    }

    /** Eye rays per pixel. */
    public int samples() {
        return values.samples;
    }

    /** How many times an eye ray may be mirrored or refracted; 0 for direct light only. */
    public int maxDepth() {
        return values.maxDepth;
    }

    /** Rays that carry less than this fraction of the radiance they find are not followed. */
    public double minimumThroughput() {
        return values.minimumThroughput;
    }

    /** The seed of all random choices. */
    public long seed() {
        return values.seed;
    }

    /** The factor from radiance to picture; not a number if it is chosen from the picture. */
    public double exposure() {
        return values.exposure;
    }

    public boolean isExposureAutomatic() {
        return Double.isNaN(values.exposure);
    }

    /** What surfaces do to light. */
    public ScatterRules scatterRules() {
        return new ScatterRules(
                values.fresnel, values.dropTotalInternalReflection, values.scaleRadiance, values.backFacingBump);
    }

    /** Whether diffuse radiance is ρE/π; ρE otherwise, as in the thesis. */
    public boolean normalizesDiffuse() {
        return values.normalizesDiffuse;
    }

    /** Whether a highlight of exponent n carries the factor (n + 1)/(2π), so that its energy does not depend on n. */
    public boolean normalizesHighlights() {
        return values.normalizesHighlights;
    }

    /** Whether straight shadow rays lose what Fresnel reflects and what media absorb on their way. */
    public boolean attenuates() {
        return values.attenuates;
    }

    /** Whether pixels are clamped to 0..1, as in the thesis. */
    public boolean clamps() {
        return values.clamps;
    }

    /** How light is traced forward from the lights. */
    public ForwardSettings forward() {
        return values.forward;
    }

    /** How the light of the forward pass is kept and read. */
    public MapSettings maps() {
        return values.maps;
    }

    /**
     * Whether every shadow ray is fired and every object asked in list order, without any shortcut, so that the counters
     * mean what the thesis' do.
     */
    public boolean usesListOrder() {
        return values.usesListOrder;
    }

    /** Collects settings; starts with {@link #physical()}. */
    public static final class Builder {
        private String shader = AUTO;
        private int samples = 1;
        private int maxDepth = 24;
        private double minimumThroughput = 0x1p-12;
        private long seed = 1;
        private double exposure = Double.NaN;
        private boolean fresnel = true;
        private boolean dropTotalInternalReflection;
        private boolean scaleRadiance = true;
        private ScatterRules.BackFacingBump backFacingBump = ScatterRules.BackFacingBump.BEND;
        private boolean normalizesDiffuse = true;
        private boolean normalizesHighlights = true;
        private boolean attenuates = true;
        private boolean clamps;
        private boolean usesListOrder;
        private ForwardSettings forward = ForwardSettings.builder().build();
        private MapSettings maps = MapSettings.builder().build();

        private Builder() {}

        private Builder(Builder other) {
            shader = other.shader;
            samples = other.samples;
            maxDepth = other.maxDepth;
            minimumThroughput = other.minimumThroughput;
            seed = other.seed;
            exposure = other.exposure;
            fresnel = other.fresnel;
            dropTotalInternalReflection = other.dropTotalInternalReflection;
            scaleRadiance = other.scaleRadiance;
            backFacingBump = other.backFacingBump;
            normalizesDiffuse = other.normalizesDiffuse;
            normalizesHighlights = other.normalizesHighlights;
            attenuates = other.attenuates;
            clamps = other.clamps;
            usesListOrder = other.usesListOrder;
            forward = other.forward;
            maps = other.maps;
        }

        /** Switches everything to the thesis' ways: depth 6, exposure 1 and what each key below says of it. */
        public Builder thesis() {
            maxDepth = 6;
            minimumThroughput = 0;
            exposure = 1;
            fresnel = false;
            dropTotalInternalReflection = true;
            scaleRadiance = false;
            backFacingBump = ScatterRules.BackFacingBump.FLIP;
            normalizesDiffuse = false;
            normalizesHighlights = false;
            attenuates = false;
            clamps = true;
            usesListOrder = true;
            forward = forward.toBuilder().thesis().build();
            return this;
        }

        public Builder shader(String name) {
            shader = name;
            return this;
        }

        /** @param raysPerPixel at least 1 */
        public Builder samples(int raysPerPixel) {
            samples = Limits.atLeast("samples", raysPerPixel, 1);
            return this;
        }

        /** @param bounces at least 0 */
        public Builder maxDepth(int bounces) {
            maxDepth = Limits.atLeast("max-depth", bounces, 0);
            return this;
        }

        /** @param fraction at least 0, below 1 */
        public Builder minimumThroughput(double fraction) {
            if (!(fraction >= 0 && fraction < 1)) {
                throw new IllegalArgumentException(
                        "minimum-throughput must be at least 0 and below 1, but is " + fraction);
            }
            minimumThroughput = fraction;
            return this;
        }

        public Builder seed(long value) {
            seed = value;
            return this;
        }

        /** @param factor positive */
        public Builder exposure(double factor) {
            if (!(factor > 0 && factor < Double.POSITIVE_INFINITY)) {
                throw new IllegalArgumentException("exposure must be positive and finite, but is " + factor);
            }
            exposure = factor;
            return this;
        }

        /** Leaves the exposure to be chosen from the picture. */
        public Builder automaticExposure() {
            exposure = Double.NaN;
            return this;
        }

        /** Whether interfaces split light by Fresnel's equations; off: by the given coefficients, as in the thesis. */
        public Builder fresnel(boolean on) {
            fresnel = on;
            return this;
        }

        /** Whether totally reflected light is lost, as in the thesis. */
        public Builder dropTotalInternalReflection(boolean on) {
            dropTotalInternalReflection = on;
            return this;
        }

        /** Whether refracted radiance is scaled by the square of the index ratio; not so in the thesis. */
        public Builder scaleRadiance(boolean on) {
            scaleRadiance = on;
            return this;
        }

        public Builder backFacingBump(ScatterRules.BackFacingBump rule) {
            backFacingBump = rule;
            return this;
        }

        public Builder normalizeDiffuse(boolean on) {
            normalizesDiffuse = on;
            return this;
        }

        public Builder normalizeHighlights(boolean on) {
            normalizesHighlights = on;
            return this;
        }

        public Builder attenuate(boolean on) {
            attenuates = on;
            return this;
        }

        public Builder clamp(boolean on) {
            clamps = on;
            return this;
        }

        public Builder listOrder(boolean on) {
            usesListOrder = on;
            return this;
        }

        public Builder forward(ForwardSettings value) {
            forward = value;
            return this;
        }

        public Builder maps(MapSettings value) {
            maps = value;
            return this;
        }

        public Settings build() {
            return new Settings(new Builder(this));
        }
    }
}
