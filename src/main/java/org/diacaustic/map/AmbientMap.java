package org.diacaustic.map;

import org.diacaustic.math.Rgb;

/** The light on one side of one object, or on both: irradiance by texel, and how many photons brought it. Immutable. */
final class AmbientMap {
    private final TexelGrid grid;
    private final JoinedTexels texels;
    private final double[] irradiance;
    private final int[] photons;

    private AmbientMap(TexelGrid grid, JoinedTexels texels, double[] irradiance, int[] photons) {
        this.grid = grid;
        this.texels = texels;
        this.irradiance = irradiance;
        this.photons = photons;
    }

    /** Sets the irradiance of the texel that the point falls into; returns the photons in it. */
    int nearest(SurfacePoint at, Rgb out) {
        int texel = texels.keeper(grid.texel(at.x, at.y, at.z));
        out.set(irradiance[3 * texel], irradiance[3 * texel + 1], irradiance[3 * texel + 2]);
        return photons[texel];
    }

    /** Sets the irradiance between the middles of the four texels around the point; returns the photons in them. */
    int interpolated(SurfacePoint at, Rgb out) {
        double column = grid.chart().u(at.x, at.y, at.z) * grid.columns() - 0.5;
        double row = Math.max(-0.5, Math.min(grid.rows() - 0.5, grid.chart().v(at.x, at.y, at.z) * grid.rows() - 0.5));
        column = Math.max(-0.5, Math.min(grid.columns() - 0.5, column));
        int left = (int) Math.floor(column);
        int low = (int) Math.floor(row);
        double right = column - left;
        double high = row - low;
        out.set(0, 0, 0);
        return add(left, low, (1 - right) * (1 - high), out)
                + add(left + 1, low, right * (1 - high), out)
                + add(left, low + 1, (1 - right) * high, out)
                + add(left + 1, low + 1, right * high, out);
    }

    private int add(int column, int row, double weight, Rgb out) {
        int texel = texels.keeper(grid.atBorder(column, row));
        out.add(weight * irradiance[3 * texel], weight * irradiance[3 * texel + 1], weight * irradiance[3 * texel + 2]);
        return photons[texel];
    }

    /** The power on the whole map: irradiance × area, texel by texel. */
    void addPower(Rgb sum) {
        for (int texel = 0; texel < photons.length; texel++) {
            double area = texels.area(texel);
            sum.add(irradiance[3 * texel] * area, irradiance[3 * texel + 1] * area, irradiance[3 * texel + 2] * area);
        }
    }

    JoinedTexels texels() {
        return texels;
    }

    /** Without the {@link #texels()}, which maps may share. */
    long bytes() {
        return (long) irradiance.length * Double.BYTES + (long) photons.length * Integer.BYTES;
    }

    /** Collects the photons of a map, in their order. */
    static final class Builder {
        private final TexelGrid grid;
        private final JoinedTexels texels;
        private final double[] power;
        private final int[] photons;

        Builder(TexelGrid grid, JoinedTexels texels) {
            this.grid = grid;
            this.texels = texels;
            this.power = new double[3 * grid.size()];
            this.photons = new int[grid.size()];
        }

        /** Adds a photon, the power in W. */
        void add(int texel, Rgb photon) {
            int keeper = texels.keeper(texel);
            power[3 * keeper] += photon.red;
            power[3 * keeper + 1] += photon.green;
            power[3 * keeper + 2] += photon.blue;
            photons[keeper]++;
        }

        long photonCount() {
            long sum = 0;
            for (int count : photons) {
                sum += count;
            }
            return sum;
        }

        int litTexels() {
            int lit = 0;
            for (int count : photons) {
                lit += count > 0 ? 1 : 0;
            }
            return lit;
        }

        /**
         * @param divisor of all powers, besides the areas
         * @param blur the side of the blur, 0 for none
         */
        AmbientMap build(double divisor, int blur) {
            for (int texel = 0; texel < photons.length; texel++) {
                if (photons[texel] > 0) {
                    double share = texels.area(texel) * divisor;
                    power[3 * texel] /= share;
                    power[3 * texel + 1] /= share;
                    power[3 * texel + 2] /= share;
                }
            }
            double[] irradiance = blur == 0 ? power : AmbientBlur.blurred(grid, texels, power, blur);
            return new AmbientMap(grid, texels, irradiance, photons);
        }
    }
}
