package org.diacaustic.trial;

import java.util.SplittableRandom;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegratorFactory;
import org.diacaustic.map.Estimator;
import org.diacaustic.map.Kernel;
import org.diacaustic.map.PhotonFilter;
import org.diacaustic.math.Vector3;
import org.diacaustic.stability.CaseFault;
import org.diacaustic.stability.Checks;
import org.diacaustic.stability.NumericCase;
import org.diacaustic.stability.Operations;

/** Whether kernels take light away or add any. */
final class KernelTrials {
    /** The height of the Gaussian filter as it was published [Jensen 1996]. */
    private static final double PUBLISHED_ALPHA = 0.918;

    private static final int NODES = 40;
    private static final int PHOTONS = 200_000;

    private KernelTrials() {}

    static void addTo(Operations operations) {
        operations.add(
                "kernel_norm",
                "The mean of the Kernel's weights over the disc, by Gauss-Legendre quadrature with 40 nodes in d/r, and a"
                        + " PhotonMap lookup of 200000 random photons (seed 1) within 4 sigma. All kernels have mean 1. The"
                        + " published Gaussian is ours times 0.918 over our height, which is the alpha that is unbiased; the"
                        + " norm of a cone is 1 over its height.",
                KernelTrials::norm);
    }

    private static void norm(NumericCase asked, Checks checks) {
        String name = asked.inputs().text("kernel");
        switch (name) {
            case "jensen_gaussian", "gaussian" -> {
                double published = PUBLISHED_ALPHA / Kernel.GAUSSIAN.weight(0) * mean(Kernel.GAUSSIAN);
                checks.number("E_ratio", published, "");
                if (asked.expected().has("underestimate_percent")) {
                    checks.number(
                            "underestimate_percent",
                            asked.expected().number("underestimate_percent"),
                            100 * (1 - published),
                            100 * asked.tolerance().number("abs"));
                }
                if (asked.expected().has("alpha_that_is_unbiased")) {
                    checks.number("alpha_that_is_unbiased", Kernel.GAUSSIAN.weight(0), "");
                }
                checks.note("published constants; the renderer's own Gaussian has E_ratio 1");
                unbiased(Kernel.GAUSSIAN, checks);
            }
            case "cone" -> cone(asked, checks);
            case "constant" -> plain(Kernel.CONSTANT, asked, checks);
            case "epanechnikov" -> plain(Kernel.EPANECHNIKOV, asked, checks);
            default -> throw new CaseFault("inputs.kernel: the renderer has no kernel '" + name + "'");
        }
    }

    private static void cone(NumericCase asked, Checks checks) {
        double slope = asked.inputs().number("k", 1);
        if (slope != 1) {
            checks.notApplicable(
                    "the renderer's cone has k = 1 only, which is the one that falls to 0 at the rim and so stays"
                            + " unbiased where the rim is at the k-th photon [Garcia et al. 2014]; not k = " + slope);
            return;
        }
        plain(Kernel.CONE, asked, checks);
        if (asked.expected().has("norm")) {
            checks.number("norm", 1 / Kernel.CONE.weight(0), "");
        }
    }

    private static void plain(Kernel kernel, NumericCase asked, Checks checks) {
        String name = asked.expected().has("E_ratio_fixed_radius") ? "E_ratio_fixed_radius" : "E_ratio";
        checks.number(name, mean(kernel), "");
        unbiased(kernel, checks);
    }

    /** With d = tr the mean over the disc is the integral of 2t · weight(t²). */
    private static double mean(Kernel kernel) {
        return new GaussIntegratorFactory().legendre(NODES, 0.0, 1.0).integrate(t -> 2 * t * kernel.weight(t * t));
    }

    private static void unbiased(Kernel kernel, Checks checks) {
        SplittableRandom random = new SplittableRandom(1);
        StoredPhotons photons = new StoredPhotons(Vector3.ZERO, 2, PHOTONS, 9.0 / PHOTONS);
        for (int i = 0; i < PHOTONS; i++) {
            photons.add(StoredPhotons.floor(random.nextDouble(-1.5, 1.5), random.nextDouble(-1.5, 1.5)));
        }
        double got = StoredPhotons.irradiance(
                photons.tree(),
                new Estimator.Density(1, kernel),
                PhotonFilter.TWO_SIDED_NORMAL,
                StoredPhotons.floor(0, 0));
        double meanSquare = new GaussIntegratorFactory()
                .legendre(NODES, 0.0, 1.0)
                .integrate(t -> 2 * t * kernel.weight(t * t) * kernel.weight(t * t));
        // One photon in the area A gives wA/π with w of mean square m within the disc, and 0 elsewhere.
        double variance = 9 / Math.PI * meanSquare - 1;
        checks.statistic("mean of a lookup", 1, got, Math.sqrt(variance / PHOTONS), 4);
    }
}
