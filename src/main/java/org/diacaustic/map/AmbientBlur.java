package org.diacaustic.map;

/**
 * Evens out the light of texels over squares of size × size. Neighbours exchange power, as much as
 * (difference of irradiance) × (smaller area) ÷ size²: what one gains the other loses, so no power is gained or lost, a uniform
 * irradiance stays as it is whatever the areas are, and none becomes negative. Where all areas are equal this is the box
 * blur; beyond an edge nothing is exchanged, as if the map went on there as it is at the texel itself. Over seam and poles
 * the texels on the other side are neighbours.
 */
final class AmbientBlur {
    private AmbientBlur() {}

    /**
     * @param irradiance red, green and blue by texel; 0 in those that keep no light
     * @param size odd
     * @return the same, blurred
     */
    static double[] blurred(TexelGrid grid, JoinedTexels texels, double[] irradiance, int size) {
        double[] blurred = irradiance.clone();
        double share = 1.0 / (size * (double) size);
        for (int texel = 0; texel < texels.size(); texel++) {
            if (texels.keepsOwn(texel)) {
                exchange(grid, texels, irradiance, texel, size / 2, share, blurred);
            }
        }
        return blurred;
    }

    private static void exchange(
            TexelGrid grid,
            JoinedTexels texels,
            double[] irradiance,
            int texel,
            int radius,
            double share,
            double[] blurred) {
        int column = texel % grid.columns();
        int row = texel / grid.columns();
        double own = texels.area(texel);
        double red = 0;
        double green = 0;
        double blue = 0;
        for (int r = row - radius; r <= row + radius; r++) {
            for (int c = column - radius; c <= column + radius; c++) {
                int other = grid.beyondBorder(c, r);
                if (other != TexelGrid.NONE && texels.keepsOwn(other)) {
                    double area = Math.min(own, texels.area(other));
                    red += area * (irradiance[3 * other] - irradiance[3 * texel]);
                    green += area * (irradiance[3 * other + 1] - irradiance[3 * texel + 1]);
                    blue += area * (irradiance[3 * other + 2] - irradiance[3 * texel + 2]);
                }
            }
        }
        blurred[3 * texel] += red / own * share;
        blurred[3 * texel + 1] += green / own * share;
        blurred[3 * texel + 2] += blue / own * share;
    }
}
