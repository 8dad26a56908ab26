package org.diacaustic.map;

import java.util.Arrays;

/**
 * Which texel keeps the light of each, and how large it is. A texel keeps its own unless it is a sliver. What has no area
 * at all and none around it gives its light, should rounding bring it any, to the nearest texel that has.
 */
final class JoinedTexels {
    /** Texels smaller than this fraction of their largest neighbour are slivers; those at a pole are thrice as large. */
    private static final double SLIVER = 1.0 / 8;

    private final int[] keepers;
    private final double[] areas;

    private JoinedTexels(int[] keepers, double[] areas) {
        this.keepers = keepers;
        this.areas = areas;
    }

    /** Texels that count alike and keep their own, whatever area they have. */
    static JoinedTexels alike(TexelGrid grid) {
        int[] own = new int[grid.size()];
        Arrays.setAll(own, i -> i);
        double[] ones = new double[grid.size()];
        Arrays.fill(ones, 1);
        return new JoinedTexels(own, ones);
    }

    /** @param areas by texel, not all zero */
    static JoinedTexels joinSlivers(TexelGrid grid, double[] areas) {
        int[] larger = new int[grid.size()];
        for (int texel = 0; texel < larger.length; texel++) {
            larger[texel] = largerOne(grid, areas, texel);
        }
        int[] keepers = new int[larger.length];
        double[] sums = new double[larger.length];
        for (int texel = 0; texel < larger.length; texel++) {
            keepers[texel] = followed(larger, texel);
            if (keepers[texel] != TexelGrid.NONE) {
                sums[keepers[texel]] += areas[texel];
            }
        }
        spread(grid, keepers);
        return new JoinedTexels(keepers, sums);
    }

    /** The texel itself, the neighbour that it joins, or none if neither has any area. */
    private static int largerOne(TexelGrid grid, double[] areas, int texel) {
        int largest = texel;
        int column = texel % grid.columns();
        int row = texel / grid.columns();
        for (int r = row - 1; r <= row + 1; r++) {
            for (int c = column - 1; c <= column + 1; c++) {
                int neighbour = grid.beyondBorder(c, r);
                if (neighbour != TexelGrid.NONE && areas[neighbour] > areas[largest]) {
                    largest = neighbour;
                }
            }
        }
        if (areas[largest] == 0) {
            return TexelGrid.NONE;
        }
        return areas[texel] < SLIVER * areas[largest] ? largest : texel;
    }

    /** Every step is to a larger area, so there is an end. */
    private static int followed(int[] larger, int start) {
        int texel = start;
        while (texel != TexelGrid.NONE && larger[texel] != texel) {
            texel = larger[texel];
        }
        return texel;
    }

    /** Gives texels without a keeper that of the nearest texel with one, in steps to neighbours. */
    private static void spread(TexelGrid grid, int[] keepers) {
        int[] queue = new int[keepers.length];
        int end = 0;
        for (int texel = 0; texel < keepers.length; texel++) {
            if (keepers[texel] != TexelGrid.NONE) {
                queue[end++] = texel;
            }
        }
        for (int next = 0; next < end; next++) {
            int column = queue[next] % grid.columns();
            int row = queue[next] / grid.columns();
            for (int r = row - 1; r <= row + 1; r++) {
                for (int c = column - 1; c <= column + 1; c++) {
                    int neighbour = grid.beyondBorder(c, r);
                    if (neighbour != TexelGrid.NONE && keepers[neighbour] == TexelGrid.NONE) {
                        keepers[neighbour] = keepers[queue[next]];
                        queue[end++] = neighbour;
                    }
                }
            }
        }
    }

    /** The texel that keeps the light of this one: itself, if it is no sliver. */
    int keeper(int texel) {
        return keepers[texel];
    }

    /** The area of a keeper with all that is joined to it; 0 of the others. */
    double area(int texel) {
        return areas[texel];
    }

    int size() {
        return keepers.length;
    }

    boolean keepsOwn(int texel) {
        return keepers[texel] == texel;
    }

    long bytes() {
        return (long) keepers.length * (Integer.BYTES + Double.BYTES);
    }
}
