package org.diacaustic.scene;

/** What keeps the light of the forward pass. */
public enum MapName {
    /** What the plan finds best. */
    AUTO,
    /** Nothing: there is no forward pass. */
    NONE,
    /** A map of texels over each object [Thesis 4.4]. */
    AMBIENT_MAPS,
    /** Photons in space, wherever they land [Thesis 4.5]. */
    PHOTON_MAP,
    /** Beams between neighbouring light rays, as cells on what they light. */
    CAUSTIC_MESH;

    /** The name in scene files and on the command line. */
    public String label() {
        return name().toLowerCase(java.util.Locale.ROOT).replace('_', '-');
    }
}
