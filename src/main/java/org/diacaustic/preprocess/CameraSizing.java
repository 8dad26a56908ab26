package org.diacaustic.preprocess;

import java.util.Optional;
import org.diacaustic.map.AmbientMaps;
import org.diacaustic.map.Chart;
import org.diacaustic.math.Ray;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.shape.Hit;

/**
 * Maps as fine as the camera needs them: the view-dependent stage before the forward pass that the thesis asks for
 * [Thesis 4.4]. A sparse grid of eye rays, straight on through what is transparent, finds the smallest footprint of a pixel on
 * each object; a texel is to be no larger. If those are too many for the memory or for the photons, all maps get coarser by
 * the same factor. What no ray finds, such as what is seen in mirrors only, has a map of the least size.
 */
public final class CameraSizing implements ChartSizing {
    /** The least number of columns and of rows: maps this small cost nothing. */
    static final int LEAST = 16;

    /** The largest number of columns and of rows, whatever the camera sees. */
    static final int LARGEST = 4096;

    /** Photons that a texel should have; with the usual blur over 9 texels that leaves a noise of one sixth. */
    static final int PHOTONS_PER_TEXEL = 4;

    private static final int RAYS_ACROSS = 64;

    /** Surfaces that an eye ray goes straight through, at most. */
    private static final int MOST_SURFACES = 32;

    private final SceneIndex scene;
    private final Chart[] charts;
    private final double[] columns;
    private final double[] rows;
    private double coarseness = 1;

    private CameraSizing(SceneIndex scene) {
        this.scene = scene;
        this.charts = new Chart[scene.size()];
        this.columns = new double[scene.size()];
        this.rows = new double[scene.size()];
        for (int i = 0; i < charts.length; i++) {
            if (scene.object(i).material().isDiffuse()) {
                Optional<SurfaceChart> surface = SurfaceChart.of(scene.object(i));
                charts[i] = surface.map(SurfaceChart::chart).orElse(null);
            }
        }
    }

    /**
     * Finds the sizes.
     *
     * @param expectedPhotons on all maps together
     * @param bytes that all maps together may take; only maps of the least size may take more
     * @throws ForwardPlanException if an object that can show diffuse light has no end
     */
    public static CameraSizing of(SceneIndex scene, Camera camera, long expectedPhotons, long bytes) {
        CameraSizing sizing = new CameraSizing(scene);
        sizing.look(camera);
        sizing.fit(Math.min(expectedPhotons / PHOTONS_PER_TEXEL, bytes / AmbientMaps.BYTES_PER_TEXEL));
        return sizing;
    }

    @Override
    public ChartSize of(int object) {
        return new ChartSize(side(columns[object], coarseness), side(rows[object], coarseness));
    }

    private static int side(double needed, double coarseness) {
        int texels = (int) Math.ceil(needed / coarseness);
        return Math.max(LEAST, texels + texels % 2);
    }

    private void look(Camera camera) {
        int across = Math.min(camera.width(), RAYS_ACROSS);
        int down = Math.min(camera.height(), RAYS_ACROSS);
        Ray ray = new Ray();
        Ray nextColumn = new Ray();
        Ray nextRow = new Ray();
        Hit hit = new Hit();
        for (int i = 0; i < down; i++) {
            double y = (i + 0.5) * camera.height() / down;
            for (int k = 0; k < across; k++) {
                double x = (k + 0.5) * camera.width() / across;
                camera.aim(x, y, 0, 0, ray);
                camera.aim(x + 1, y, 0, 0, nextColumn);
                camera.aim(x, y + 1, 0, 0, nextRow);
                follow(ray, hit, nextColumn, nextRow);
            }
        }
    }

    private void follow(Ray ray, Hit hit, Ray nextColumn, Ray nextRow) {
        int object = scene.nearest(ray, SceneIndex.NONE, 0);
        for (int surfaces = 0; object != SceneIndex.NONE && surfaces < MOST_SURFACES; surfaces++) {
            hit.take(ray);
            scene.object(object).shape().complete(ray, hit);
            if (charts[object] != null) {
                need(object, hit, nextColumn, nextRow);
            }
            if (scene.isOpaque(object)) {
                return;
            }
            int leaving = object;
            ray.set(hit.x, hit.y, hit.z, ray.directionX, ray.directionY, ray.directionZ);
            ray.departureError = hit.pointError;
            object = scene.nearest(ray, leaving, hit.primitive);
        }
    }

    /** Notes how many texels it takes for one to be no larger than the footprint of the pixel. */
    private void need(int object, Hit hit, Ray nextColumn, Ray nextRow) {
        Chart chart = charts[object];
        double u = chart.u(hit.x, hit.y, hit.z);
        double v = chart.v(hit.x, hit.y, hit.z);
        double stepU = 0;
        double stepV = 0;
        for (int i = 0; i < 2; i++) {
            Ray next = i == 0 ? nextColumn : nextRow;
            double t = ((hit.x - next.originX) * hit.normalX
                            + (hit.y - next.originY) * hit.normalY
                            + (hit.z - next.originZ) * hit.normalZ)
                    / (next.directionX * hit.normalX + next.directionY * hit.normalY + next.directionZ * hit.normalZ);
            if (!(t > 0 && t < Double.POSITIVE_INFINITY)) {
                return;
            }
            double du = Math.abs(chart.u(next.pointX(t), next.pointY(t), next.pointZ(t)) - u);
            stepU += chart.goesAround() ? Math.min(du, 1 - du) : du;
            stepV += Math.abs(chart.v(next.pointX(t), next.pointY(t), next.pointZ(t)) - v);
        }
        columns[object] = Math.max(columns[object], Math.min(LARGEST, 1 / stepU));
        rows[object] = Math.max(rows[object], Math.min(LARGEST, 1 / stepV));
    }

    /** Makes all maps coarser until they have no more texels than the limit, or are as small as they can be. */
    private void fit(long limit) {
        double fine = 1;
        double coarse = LARGEST;
        if (texels(fine) <= limit) {
            return;
        }
        while (coarse > fine * (1 + 0x1p-20)) {
            double middle = Math.sqrt(fine * coarse);
            if (texels(middle) > limit) {
                fine = middle;
            } else {
                coarse = middle;
            }
        }
        coarseness = coarse;
    }

    private long texels(double factor) {
        long sum = 0;
        for (int i = 0; i < charts.length; i++) {
            sum += charts[i] == null ? 0 : (long) side(columns[i], factor) * side(rows[i], factor);
        }
        return sum;
    }
}
