package org.diacaustic.trial;

import java.util.List;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegrator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegratorFactory;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.diacaustic.light.LightPoint;
import org.diacaustic.light.PointLight;
import org.diacaustic.map.PhotonStore;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Color;
import org.diacaustic.math.CompensatedSum;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.preprocess.Beam;
import org.diacaustic.preprocess.EmissionChart;
import org.diacaustic.scene.Scene;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Where rays leave lights for, and what each of them carries. */
final class EmissionTrials {
    /** The chance that any of a case's chi-squares is out of its bounds by chance. */
    private static final double SIGNIFICANCE = 0.01;

    private static final int NODES = 32;

    private EmissionTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "disc_count",
                "A forward pass (seed 1) of N rays into all directions from a lamp of 1 W/sr over a floor, through a sheet of"
                        + " index 1, which lets photons of a bare floor's light be stored. With 'random' rays the photons in the"
                        + " disc are counted; with 'cube' their part of the flux must be within the same bound of N.",
                EmissionTrials::count);
        operations.add(
                "chi2_directions",
                "N rays that the pre-processor 'random' (seed 1) sends from each light into all directions, kept with a chance"
                        + " like the intensity that the light gives them, so that they are as dense as its flux; their cells"
                        + " are of equal flux. Chi-square must lie between the two quantiles that all lights together leave with"
                        + " a chance of 0.01 (Sidak), so not be too small either, and below reject_above.",
                EmissionTrials::directions);
        operations.add(
                "cube_weights",
                "The charts that 'cube', 'adaptive' and the caustic mesh lay lattices on: the solid angle that their density"
                        + " gives rays in the middle of cells, and its integral by 32 x 32 Gauss-Legendre nodes a face, which must"
                        + " be 4 pi. The gain is that of rays that all carry the same, which only the thesis' mode does.",
                EmissionTrials::cube);
    }

    private static void count(NumericCase asked, Checks checks) {
        double height = positive(asked, "h");
        double radius = positive(asked, "r");
        long rays = asked.inputs().integer("N");
        double sigmas = asked.tolerance().number("z_max");
        double deviation = asked.expected().number("sd");
        Scene scene = LitFloor.under(
                height / 2, 0.55 * radius, 2 * radius, new PointLight(new Vector3(0, height, 0), Color.WHITE));
        PhotonStore random = LightRun.of(scene, LitFloor.everywhere(radius, 1), "random", rays)
                .photons();
        double mean = asked.expected().number("mean");
        checks.statistic("photons in the disc", mean, inDisc(random, radius, false), deviation, sigmas);
        PhotonStore cube =
                LightRun.of(scene, LitFloor.everywhere(radius, 1), "cube", rays).photons();
        double part = inDisc(cube, radius, true) / (4 * Math.PI);
        checks.statistic("part of the flux, cube", asked.expected().number("p"), part, deviation / rays, sigmas);
    }

    /** The number of photons within a radius of the middle, or their power, in W. */
    private static double inDisc(PhotonStore photons, double radius, boolean asPower) {
        SurfacePoint at = new SurfacePoint();
        Rgb power = new Rgb();
        CompensatedSum sum = new CompensatedSum();
        for (int i = 0; i < photons.size(); i++) {
            photons.position(i, at);
            if (at.x * at.x + at.z * at.z <= radius * radius) {
                photons.power(i, power);
                sum.add(asPower ? power.green : 1);
            }
        }
        return sum.value();
    }

    private static void directions(NumericCase asked, Checks checks) {
        int bins = (int) asked.inputs().integer("bins");
        long rays = asked.inputs().integer("N");
        List<String> lights = asked.inputs().texts("lights");
        if (bins < 2 || rays < 10L * bins || lights.isEmpty()) {
            throw new CaseFault("a chi-square needs two cells, ten rays for each, and a light");
        }
        checks.same("df", asked.expected().integer("df"), (long) bins - 1);
        ChiSquaredDistribution distribution = new ChiSquaredDistribution(bins - 1);
        double tail = 0.5 * -Math.expm1(Math.log1p(-SIGNIFICANCE) / lights.size());
        double least = distribution.inverseCumulativeProbability(tail);
        double most = distribution.inverseCumulativeProbability(1 - tail);
        if (asked.expected().has("reject_above_p1e-9")) {
            most = Math.min(most, asked.expected().number("reject_above_p1e-9"));
        }
        for (String name : lights) {
            double chiSquare = DirectionCells.of(name, bins).chiSquare(rays);
            checks.atMost("chi-square of " + name, most, chiSquare);
            checks.holds("chi-square of " + name + " is at least " + (float) least, chiSquare >= least);
        }
    }

    private static void cube(NumericCase asked, Checks checks) {
        int cells = (int) asked.inputs().integer("cells_per_edge");
        if (cells < 1 || cells > 10_000) {
            throw new CaseFault("inputs.cells_per_edge should be from 1 to 10000, but is " + cells);
        }
        Scene scene = LitFloor.under(1, 1, 1, new PointLight(new Vector3(0, 2, 0), Color.WHITE));
        Beam beam = LightRun.plan(scene, LitFloor.everywhere(1, 1), "cube", 6L * cells * cells)
                .beams()
                .get(0);
        LightPoint from = new LightPoint();
        beam.light().emitFrom(0.5, 0.5, from);
        List<EmissionChart> faces = beam.cubeCharts(from);
        checks.same("faces", 6, faces.size());
        double rounding = asked.tolerance().number("sum_rel_exact_formula", 1e-13) * 4 * Math.PI;
        CompensatedSum midpoints = new CompensatedSum();
        GaussIntegrator nodes = new GaussIntegratorFactory().legendre(NODES, 0.0, 1.0);
        CompensatedSum exact = new CompensatedSum();
        for (EmissionChart face : faces) {
            for (int i = 0; i < cells * cells; i++) {
                int row = i / cells;
                double p = (row + 0.5) / cells;
                double q = (i % cells + 0.5) / cells;
                midpoints.add(face.density(p, q) / cells / cells);
            }
            exact.add(nodes.integrate(p -> nodes.integrate(q -> face.density(p, q))));
        }
        double centre = faces.get(0).density(0.5, 0.5);
        checks.number("corner_to_centre_density_ratio", centre / faces.get(0).density(0, 0), "sum_rel_exact_formula");
        checks.number(
                "midpoint_solid_angle_sum_minus_4pi",
                asked.expected().number("midpoint_solid_angle_sum_minus_4pi"),
                midpoints.value() - 4 * Math.PI,
                rounding);
        checks.number("sum of exact solid angles", 4 * Math.PI, exact.value(), rounding);
        if (asked.expected().has("unweighted_axis_gain")) {
            checks.number("unweighted_axis_gain", 4 * Math.PI / faces.size() / centre);
        }
        checks.note("rays carry the density at their place of a lattice shifted at random, so 4 pi on average");
    }

    private static double positive(NumericCase asked, String name) {
        double number = asked.inputs().number(name);
        if (!(number > 0 && number < Double.POSITIVE_INFINITY)) {
            throw new CaseFault("inputs." + name + " should be positive and finite, but is " + number);
        }
        return number;
    }
}
