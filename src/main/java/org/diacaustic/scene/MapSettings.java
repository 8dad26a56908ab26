package org.diacaustic.scene;

import org.diacaustic.map.Kernel;

/**
 * How the light of the forward pass is kept and read: names and numbers only, nothing resolved. Immutable; a part of
 * {@link Settings}.
 */
public final class MapSettings {
    private final Builder values;

    private MapSettings(Builder values) {
        this.values = values;
    }

    public static Builder builder() {
        return new Builder();
    }

    public Builder toBuilder() {
        return new Builder(values);
    }

    /** What keeps the light. */
    public MapName map() {
        return values.map;
    }

    /** How it is read. */
    public EstimatorName estimator() {
        return values.estimator;
    }

    /** Whether light that landed on the other side of a surface, or on one at an angle, is left out; it was not in the thesis (4.8). */
    public boolean filtersSides() {
        return values.filterSides;
    }

    /** How photons count by their distance. */
    public Kernel kernel() {
        return values.kernel;
    }

    /** How far photons are looked for, in scene units. 0: from the photons. */
    public double gatherRadius() {
        return values.gatherRadius;
    }

    /** How many nearest photons are looked for. */
    public int gatherCount() {
        return values.gatherCount;
    }

    /** The number of photons expected within reach [Thesis 4.5]. 0: from the photons. */
    public double expectedCount() {
        return values.expectedCount;
    }

    /** Texels of an ambient map around or across its object. 0: as the camera needs them. */
    public int mapColumns() {
        return values.mapColumns;
    }

    /** Texels up its object. 0: as the camera needs them. */
    public int mapRows() {
        return values.mapRows;
    }

    /** Texels along the side of the box that ambient maps are blurred with; 1 for none. */
    public int mapBlur() {
        return values.mapBlur;
    }

    /** Whether irradiance between the middles of texels is interpolated; it was not in the thesis. */
    public boolean interpolatesTexels() {
        return values.interpolateTexels;
    }

    /** How many primary rays an area of a refracting object lets through [Thesis 4.4]. 0: all. */
    public int initialHits() {
        return values.initialHits;
    }

    /** Areas across such an object. */
    public int initialHitColumns() {
        return values.initialHitColumns;
    }

    /** Areas up such an object. */
    public int initialHitRows() {
        return values.initialHitRows;
    }

    /** Collects the settings; starts with the physical ones. */
    public static final class Builder {
        private MapName map = MapName.AUTO;
        private EstimatorName estimator = EstimatorName.AUTO;
        private boolean filterSides = true;
        private Kernel kernel = Kernel.EPANECHNIKOV;
        private double gatherRadius;
        private int gatherCount = 50;
        private double expectedCount;
        private int mapColumns;
        private int mapRows;
        private int mapBlur = 3;
        private boolean interpolateTexels = true;
        private int initialHits;
        private int initialHitColumns = 140;
        private int initialHitRows = 141;

        private Builder() {}

        private Builder(Builder other) {
            map = other.map;
            estimator = other.estimator;
            filterSides = other.filterSides;
            kernel = other.kernel;
            gatherRadius = other.gatherRadius;
            gatherCount = other.gatherCount;
            expectedCount = other.expectedCount;
            mapColumns = other.mapColumns;
            mapRows = other.mapRows;
            mapBlur = other.mapBlur;
            interpolateTexels = other.interpolateTexels;
            initialHits = other.initialHits;
            initialHitColumns = other.initialHitColumns;
            initialHitRows = other.initialHitRows;
        }

        public Builder map(MapName value) {
            map = value;
            return this;
        }

        public Builder estimator(EstimatorName value) {
            estimator = value;
            return this;
        }

        public Builder filterSides(boolean value) {
            filterSides = value;
            return this;
        }

        public Builder kernel(Kernel value) {
            kernel = value;
            return this;
        }

        public Builder gatherRadius(double value) {
            gatherRadius = Limits.atLeast("gather-radius", value, 0);
            return this;
        }

        public Builder gatherCount(int value) {
            gatherCount = Limits.atLeast("gather-count", value, 2);
            return this;
        }

        public Builder expectedCount(double value) {
            expectedCount = Limits.atLeast("expected-count", value, 0);
            return this;
        }

        public Builder mapColumns(int value) {
            mapColumns = Limits.atLeast("map-columns", value, 0);
            return this;
        }

        public Builder mapRows(int value) {
            mapRows = Limits.atLeast("map-rows", value, 0);
            return this;
        }

        public Builder mapBlur(int value) {
            mapBlur = Limits.atLeast("map-blur", value, 1);
            return this;
        }

        public Builder interpolateTexels(boolean value) {
            interpolateTexels = value;
            return this;
        }

        public Builder initialHits(int value) {
            initialHits = Limits.atLeast("initial-hits", value, 0);
            return this;
        }

        public Builder initialHitColumns(int value) {
            initialHitColumns = Limits.atLeast("initial-hit-columns", value, 1);
            return this;
        }

        public Builder initialHitRows(int value) {
            initialHitRows = Limits.atLeast("initial-hit-rows", value, 1);
            return this;
        }

        public MapSettings build() {
            return new MapSettings(new Builder(this));
        }
    }
}
