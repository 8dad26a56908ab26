package org.diacaustic.fault;

/** A scene of a few lines, which renders in no time; faults change a piece of it. */
final class FaultScene {
    static final String RADIUS = "radius: 1";
    static final String GREY = "diffuse: 0.5";
    static final String IOR = "ior: 1.5";
    static final String RAYS = "rays: 2000";

    static final String TEXT = """
            camera: {from: [0, 2, 6], to: [0, 0, 0], size: [20, 16]}
            lights:
              - point: {at: [0, 9, 0], intensity: 100}
            materials:
              grey: {diffuse: 0.5}
              glass: {transparency: 0.9, ior: 1.5}
            objects:
              - sphere:
                  name: ball
                  at: [0, 0, 0]
                  radius: 1
                  material: glass
              - plane: {name: floor, at: [0, -1, 0], normal: [0, 1, 0], material: grey}
            settings: {rays: 2000}
            """;

    private FaultScene() {}

    /** The scene with one piece of its text replaced. */
    static String with(String piece, String replacement) {
        if (!TEXT.contains(piece)) {
            throw new IllegalArgumentException("the scene does not contain " + piece);
        }
        return TEXT.replace(piece, replacement);
    }

    /** The scene with one more object, such as {@code disc: {radius: 0}}, of the diffuse material. */
    static String withObject(String kind, String keys) {
        return with("settings:", "  - " + kind + ": {" + keys + ", material: grey}\nsettings:");
    }

    /** The scene without the lines from one that begins so up to one that begins otherwise. */
    static String without(String from, String upTo) {
        return TEXT.substring(0, TEXT.indexOf(from)) + TEXT.substring(TEXT.indexOf(upTo));
    }
}
