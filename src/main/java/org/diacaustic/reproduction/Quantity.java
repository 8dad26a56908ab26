package org.diacaustic.reproduction;

/**
 * What is counted [Thesis 5.2]. Those of the thesis' tables come first; the others are ours, and show what explains them.
 */
enum Quantity {
    EYE_TESTS("eyeTests", "Intersection tests"),
    SHADOW_RAYS("shadowRays", "Shadow rays"),
    REFLECTION_RAYS("reflectionRays", "Reflection rays"),
    REFRACTION_RAYS("refractionRays", "Refraction rays"),
    LIGHT_TESTS("lightTests", "Intersection tests"),
    OBJECT_INTERSECTIONS("objectIntersections", "Object intersections"),
    STORED("stored", "Stored"),
    RAYS_TRACED("raysTraced", "Rays traced"),
    PERCENT_INTERSECTING("percentIntersecting", "Rays that intersect, %"),
    PERCENT_STORED("percentStored", "Rays stored, %"),
    NODES_EXAMINED("nodesExamined", "Nodes examined"),
    PHOTONS_USED("photonsUsed", "Photons used"),

    /** Of a balanced tree over the same photons, asked at the same points. */
    BALANCED_NODES("balancedNodes", "Nodes, balanced tree"),
    /** Photons that others were compared with on their way into the thesis' tree. */
    INSERTION_STEPS("insertionSteps", "Steps of insertion"),
    /** Levels of the thesis' unbalanced tree. */
    TREE_HEIGHT("treeHeight", "Height of the tree"),
    MOST_NODES("mostNodesInALookup", "Most nodes in one lookup"),
    /** Photons used that lie on another object than the point that asks, or on its other side. */
    FOREIGN_PHOTONS("foreignPhotonsUsed", "Photons used from elsewhere"),
    LOOKUPS("lookups", "Lookups"),
    PRIMARY_RAYS("primaryRays", "Primary light rays"),
    PRIMARY_HITS("primaryHits", "Primary light rays that hit"),
    LIGHT_HITS("lightHits", "Light rays that hit"),
    /** Wall clock, on one thread: light rays, and the thesis' tree of the photons that they bring. */
    PREPROCESSING_SECONDS("preprocessingSeconds", "Pre-processing, s");

    private final String key;
    private final String title;

    Quantity(String key, String title) {
        this.key = key;
        this.title = title;
    }

    /** The name in JSON. */
    String key() {
        return key;
    }

    String title() {
        return title;
    }

    boolean isPercentage() {
        return this == PERCENT_INTERSECTING || this == PERCENT_STORED;
    }

    /** Digits after the point that mean something. */
    int decimals() {
        return isPercentage() || this == PREPROCESSING_SECONDS ? 2 : 0;
    }
}
