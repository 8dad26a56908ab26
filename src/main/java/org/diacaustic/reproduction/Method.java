package org.diacaustic.reproduction;

import java.util.Locale;

/** How a technique of the thesis finds light: a shading model alone, or a pre-processor [Thesis 3.2, 4.2 - 4.7.1]. */
enum Method {
    NON_TRANSPARENT("Non-transparent shading", false),
    NON_REFRACTIVE("Non-refractive shading", false),
    RANDOM("Completely random", true),
    MONTE_CARLO("Monte-Carlo random", true),
    PLANAR("Planar interpolation", false),
    CUBE("Brute-force spherical interpolation", false),
    ADAPTIVE("Adaptive spherical interpolation", false);

    private final String title;
    private final boolean random;

    Method(String title, boolean random) {
        this.title = title;
        this.random = random;
    }

    /** The name of the shading model or the pre-processor in settings. */
    String key() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    String title() {
        return title;
    }

    /** Whether counts depend on the seed. */
    boolean isRandom() {
        return random;
    }

    boolean isShadingModel() {
        return this == NON_TRANSPARENT || this == NON_REFRACTIVE;
    }
}
