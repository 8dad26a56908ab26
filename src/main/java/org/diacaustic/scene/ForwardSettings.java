package org.diacaustic.scene;

/**
 * How light is traced forward from the lights: names and numbers only, nothing resolved. Immutable; a part of
 * {@link Settings}.
 */
public final class ForwardSettings {
    private final Builder values;

    private ForwardSettings(Builder values) {
        this.values = values;
    }

    public static Builder builder() {
        return new Builder();
    }

    public Builder toBuilder() {
        return new Builder(values);
    }

    /** How light rays are chosen: {@code auto}, {@code none} or the name of a pre-processor. */
    public String preProcessor() {
        return values.preProcessor;
    }

    /** Light rays chosen in all for one pass; what follows from them is not counted. 0: left to the plan. */
    public long rays() {
        return values.rays;
    }

    /** Independent passes whose pictures are averaged. */
    public int passes() {
        return values.passes;
    }

    /** How often light may be mirrored or refracted before it lands. */
    public int maxDepth() {
        return values.maxDepth;
    }

    /** Whether mirrored light is followed; not so in the thesis. */
    public boolean followsReflections() {
        return values.followReflections;
    }

    /** What a light ray carries. */
    public Weights weights() {
        return values.weights;
    }

    /** Whether rays are aimed only at the objects that refract or mirror; otherwise at the whole scene, as in the thesis. */
    public boolean aimsAtSpecular() {
        return values.aimAtSpecular;
    }

    /** Whether lattices are shifted by a random part of a step, so that they are right on average; otherwise they begin at the edge, as in the thesis. */
    public boolean shiftsLattice() {
        return values.shiftLattice;
    }

    /** Whether random directions are uniform on the sphere; otherwise they are random vectors in a cube, normalised, as in the thesis. */
    public boolean usesUniformDirections() {
        return values.uniformDirections;
    }

    /** Points along the side of the planar lattice, of a face of the cube, of an object's own map, or of the first level of the adaptive one. 0: from the number of rays. */
    public int latticeSize() {
        return values.latticeSize;
    }

    /** Parts along a side into which the adaptive lattice cuts a cell. */
    public int split() {
        return values.split;
    }

    /** How often the adaptive lattice cuts. */
    public int splitDepth() {
        return values.splitDepth;
    }

    /** Random rays that look where Monte-Carlo batches are worth it. 0: from the number of rays. */
    public long baseRays() {
        return values.baseRays;
    }

    /** Rays of one batch. 0: from the number of rays. */
    public long batchRays() {
        return values.batchRays;
    }

    /** How far the rays of a batch lie from their base ray: the largest change of the unit direction. 0: as far as the next base rays are. */
    public double batchSpread() {
        return values.batchSpread;
    }

    /** Collects the settings; starts with the physical ones. */
    public static final class Builder {
        private String preProcessor = Settings.AUTO;
        private long rays;
        private int passes = 1;
        private int maxDepth = 24;
        private boolean followReflections = true;
        private Weights weights = Weights.AUTO;
        private boolean aimAtSpecular = true;
        private boolean shiftLattice = true;
        private boolean uniformDirections = true;
        private int latticeSize;
        private int split = 2;
        private int splitDepth = 2;
        private long baseRays;
        private long batchRays;
        private double batchSpread;

        private Builder() {}

        private Builder(Builder other) {
            preProcessor = other.preProcessor;
            rays = other.rays;
            passes = other.passes;
            maxDepth = other.maxDepth;
            followReflections = other.followReflections;
            weights = other.weights;
            aimAtSpecular = other.aimAtSpecular;
            shiftLattice = other.shiftLattice;
            uniformDirections = other.uniformDirections;
            latticeSize = other.latticeSize;
            split = other.split;
            splitDepth = other.splitDepth;
            baseRays = other.baseRays;
            batchRays = other.batchRays;
            batchSpread = other.batchSpread;
        }

        /** Switches everything to the thesis' ways: see the notes at each. */
        Builder thesis() {
            maxDepth = 1;
            followReflections = false;
            aimAtSpecular = false;
            shiftLattice = false;
            uniformDirections = false;
            split = 5;
            batchSpread = 0.036;
            return this;
        }

        public Builder preProcessor(String value) {
            preProcessor = value;
            return this;
        }

        public Builder rays(long value) {
            rays = Limits.atLeast("rays", value, 0);
            return this;
        }

        public Builder passes(int value) {
            passes = Limits.atLeast("passes", value, 1);
            return this;
        }

        public Builder maxDepth(int value) {
            maxDepth = Limits.atLeast("light-depth", value, 0);
            return this;
        }

        public Builder followReflections(boolean value) {
            followReflections = value;
            return this;
        }

        public Builder weights(Weights value) {
            weights = value;
            return this;
        }

        public Builder aimAtSpecular(boolean value) {
            aimAtSpecular = value;
            return this;
        }

        public Builder shiftLattice(boolean value) {
            shiftLattice = value;
            return this;
        }

        public Builder uniformDirections(boolean value) {
            uniformDirections = value;
            return this;
        }

        public Builder latticeSize(int value) {
            latticeSize = Limits.atLeast("lattice-size", value, 0);
            return this;
        }

        public Builder split(int value) {
            split = Limits.atLeast("split", value, 2);
            return this;
        }

        public Builder splitDepth(int value) {
            splitDepth = Limits.atLeast("split-depth", value, 0);
            return this;
        }

        public Builder baseRays(long value) {
            baseRays = Limits.atLeast("base-rays", value, 0);
            return this;
        }

        public Builder batchRays(long value) {
            batchRays = Limits.atLeast("batch-rays", value, 0);
            return this;
        }

        public Builder batchSpread(double value) {
            batchSpread = Limits.atLeast("batch-spread", value, 0);
            return this;
        }

        public ForwardSettings build() {
            return new ForwardSettings(new Builder(this));
        }
    }
}
