package org.diacaustic.shape;

import org.diacaustic.math.Vector3;

/** Where the children of a sphere of a flake sit; each touches its parent from outside. */
public enum FlakeKind {
    /**
     * Six children, along both ways of three axes that are the same for all spheres. The one that points back sits
     * inside its grandparent, where only a transparent flake shows it.
     */
    OCTAHEDRAL(6, false),

    /**
     * Nine children: six around the equator, three towards the pole, which points away from the parent [Haines 1987].
     * With a third of the radius every level has the area of the root.
     */
    CLASSIC(9, true);

    private static final double COS_30 = Math.sqrt(3) / 2;
    private static final double OUT = Math.sqrt(1.0 / 3);
    private static final double RISE = Math.sqrt(2.0 / 3);

    private final int children;
    private final boolean turnsOutward;

    FlakeKind(int children, boolean turnsOutward) {
        this.children = children;
        this.turnsOutward = turnsOutward;
    }

    public int children() {
        return children;
    }

    /** Whether the pole of a child points away from its parent, not along that of the root. */
    boolean turnsOutward() {
        return turnsOutward;
    }

    /** The directions of the children in the frame of their parent, whose pole is z and whose equator begins at x. */
    Vector3[] directions() {
        return switch (this) {
            case OCTAHEDRAL ->
                new Vector3[] {
                    new Vector3(1, 0, 0),
                    new Vector3(-1, 0, 0),
                    new Vector3(0, 1, 0),
                    new Vector3(0, -1, 0),
                    new Vector3(0, 0, 1),
                    new Vector3(0, 0, -1)
                };
            case CLASSIC ->
                new Vector3[] {
                    new Vector3(1, 0, 0),
                    new Vector3(0.5, COS_30, 0),
                    new Vector3(-0.5, COS_30, 0),
                    new Vector3(-1, 0, 0),
                    new Vector3(-0.5, -COS_30, 0),
                    new Vector3(0.5, -COS_30, 0),
                    new Vector3(OUT * COS_30, OUT / 2, RISE),
                    new Vector3(-OUT * COS_30, OUT / 2, RISE),
                    new Vector3(0, -OUT, RISE)
                };
        };
    }
}
