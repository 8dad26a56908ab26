package org.diacaustic.preprocess;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.diacaustic.light.Light;
import org.diacaustic.light.LightPoint;
import org.diacaustic.math.Bounds;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.ForwardSettings;
import org.diacaustic.scene.MediumStack;
import org.diacaustic.scene.SceneIndex;
import org.diacaustic.shape.Shape;

/**
 * What a pre-processor is given to choose rays in: one light, one window that it shines into, and a number of rays. Immutable
 * and shared by threads.
 */
public final class Beam {
    private final int number;
    private final SceneIndex scene;
    private final Light light;
    private final EmissionWindow window;
    private final String aim;
    private final long rays;
    private final ForwardSettings settings;
    private final MediumStack mediaAtLight;
    private final double startDistance;
    private final double typicalDepositFactor;
    private final int[] endlessObjects;
    /** Null if it depends on the point of the light. */
    private final EmissionChart uniformChart;

    /**
     * @param number of the beam in its plan
     * @param aim what the window holds, in words
     * @param startDistance how far before the middle of the window parallel rays start, beyond everything that has bounds
     * @param typicalDepositFactor see {@link #typicalDepositFactor()}
     */
    Beam(
            int number,
            SceneIndex scene,
            Light light,
            EmissionWindow window,
            String aim,
            long rays,
            ForwardSettings settings,
            MediumStack mediaAtLight,
            double startDistance,
            double typicalDepositFactor) {
        this.number = number;
        this.scene = scene;
        this.light = light;
        this.window = window;
        this.aim = aim;
        this.rays = rays;
        this.settings = settings;
        this.mediaAtLight = mediaAtLight;
        this.startDistance = startDistance;
        this.typicalDepositFactor = typicalDepositFactor;
        this.endlessObjects = isParallel() ? endlessObjects(scene) : new int[0];
        this.uniformChart = light.isVisible() ? null : uniformChart();
    }

    private static int[] endlessObjects(SceneIndex scene) {
        return IntStream.range(0, scene.size())
                .filter(i -> isEndless(scene.object(i).shape()))
                .toArray();
    }

    /** Whether a shape has points, but no bounds. */
    static boolean isEndless(Shape shape) {
        return !shape.bounds().isEmpty() && !shape.bounds().isFinite();
    }

    private EmissionChart uniformChart() {
        LightPoint only = new LightPoint();
        light.emitFrom(0.5, 0.5, only);
        return makeUniformChart(only);
    }

    /** The number of the beam among those of the forward pass, from 0. */
    public int number() {
        return number;
    }

    public Light light() {
        return light;
    }

    /** What it is aimed at, in words. */
    public String aim() {
        return aim;
    }

    /** How many rays the pre-processor may choose. */
    public long rays() {
        return rays;
    }

    /** The parameters of the pre-processors. */
    public ForwardSettings settings() {
        return settings;
    }

    SceneIndex scene() {
        return scene;
    }

    /** The numbers of the objects in the window that refract or mirror what the forward pass follows. */
    IntStream specularObjects() {
        return window.objects().stream().filter(i -> EmissionWindows.isSpecular(scene.object(i), settings));
    }

    /** How far before the middle of the window parallel rays start. */
    double startDistance() {
        return startDistance;
    }

    /**
     * What a flux is multiplied by where it lands, about: without it, lights of different falloff cannot be compared by their
     * fluxes. 1 in nature.
     */
    double typicalDepositFactor() {
        return typicalDepositFactor;
    }

    /** The numbers of the objects that parallel rays may have met before they start; none for other rays. Not to be changed. */
    int[] endlessObjects() {
        return endlessObjects;
    }

    EmissionWindow window() {
        return window;
    }

    MediumStack mediaAtLight() {
        return mediaAtLight;
    }

    /** How many points stand for the light where its rays are laid out in lattices. */
    public int pointCount() {
        return light.sampleCount();
    }

    /** The light rays of a point, laid out so that equal areas are equal parts of light space. */
    public EmissionChart uniformChart(LightPoint from) {
        return uniformChart == null ? makeUniformChart(from) : uniformChart;
    }

    private EmissionChart makeUniformChart(LightPoint from) {
        if (isParallel()) {
            return parallelChart(from);
        }
        View view = new View(from, window);
        return new ConeChart(from, view.axis, settings.aimsAtSpecular() ? view.versine : 2);
    }

    /**
     * The light rays of a point through a plane before the window [Thesis 4.6].
     *
     * @throws IllegalArgumentException if {@link #planeRefusal} says why there is none
     */
    public EmissionChart planeChart(LightPoint from) {
        planeRefusal(from).ifPresent(reason -> {
            throw new IllegalArgumentException(reason);
        });
        if (isParallel()) {
            return parallelChart(from);
        }
        if (!settings.aimsAtSpecular()) {
            return boxFaceChart(from);
        }
        View view = new View(from, window);
        return tangentChart(from, view.axis, view.u, view.v, view.minU, view.maxU, view.minV, view.maxV);
    }

    /** Why no single plane covers the window as the point sees it; empty if one does. */
    public Optional<String> planeRefusal(LightPoint from) {
        if (!window.bounds().isFinite()) {
            return Optional.of(aim + " has no bounds");
        }
        Optional<String> endless = specularObjects()
                .mapToObj(scene::object)
                .filter(object -> isEndless(object.shape()))
                .map(object -> "'" + object.name() + "' has no bounds")
                .findFirst();
        if (endless.isPresent()) {
            return endless;
        }
        boolean covers = isParallel()
                || (settings.aimsAtSpecular()
                        ? new View(from, window).isInFront
                        : !window.bounds().contains(from.x, from.y, from.z));
        return covers ? Optional.empty() : Optional.of("the light lies in the bounds of " + aim + ", or close to them");
    }

    /** The light rays of a point through the faces of a cube around it, as far as the window is behind them [Thesis 4.7]. */
    public List<EmissionChart> cubeCharts(LightPoint from) {
        if (isParallel()) {
            return List.of(parallelChart(from));
        }
        View view = new View(from, window);
        if (!settings.aimsAtSpecular() || !view.isInFront) {
            return wholeCube(from);
        }
        List<EmissionChart> charts = new ArrayList<>();
        double minU = Math.max(-1, view.minU);
        double maxU = Math.min(1, view.maxU);
        double minV = Math.max(-1, view.minV);
        double maxV = Math.min(1, view.maxV);
        charts.add(tangentChart(from, view.axis, view.u, view.v, minU, maxU, minV, maxV));
        addSide(charts, from, view.axis, view.u, view.v, view.maxU);
        addSide(charts, from, view.axis, view.u.negated(), view.v, -view.minU);
        addSide(charts, from, view.axis, view.v, view.u, view.maxV);
        addSide(charts, from, view.axis, view.v.negated(), view.u, -view.minV);
        return charts;
    }

    /** The part of a side of the cube, from the front face back to the given tangent of the angle to the axis. */
    private static void addSide(
            List<EmissionChart> charts, LightPoint from, Vector3 axis, Vector3 side, Vector3 along, double tangent) {
        if (tangent > 1) {
            double back = 1 / tangent;
            charts.add(new PlaneChart(
                    from, side.minus(along).plus(axis.times(back)), along.times(2), axis.times(1 - back)));
        }
    }

    private static EmissionChart tangentChart(
            LightPoint from, Vector3 axis, Vector3 u, Vector3 v, double minU, double maxU, double minV, double maxV) {
        Vector3 corner = axis.plus(u.times(minU)).plus(v.times(minV));
        return new PlaneChart(from, corner, u.times(maxU - minU), v.times(maxV - minV));
    }

    private static List<EmissionChart> wholeCube(LightPoint from) {
        List<EmissionChart> charts = new ArrayList<>();
        Vector3[] axes = {Vector3.UNIT_X, Vector3.UNIT_Y, Vector3.UNIT_Z};
        for (int i = 0; i < 3; i++) {
            Vector3 u = axes[i == 0 ? 1 : 0];
            Vector3 v = axes[i == 2 ? 1 : 2];
            for (Vector3 axis : List.of(axes[i], axes[i].negated())) {
                charts.add(tangentChart(from, axis, u, v, -1, 1, -1, 1));
            }
        }
        return charts;
    }

    /** The face of the window's box that looks at the point most directly [Thesis 4.6]. */
    private EmissionChart boxFaceChart(LightPoint from) {
        Bounds box = window.bounds();
        double[] low = {box.minX(), box.minY(), box.minZ()};
        double[] high = {box.maxX(), box.maxY(), box.maxZ()};
        double[] at = {from.x, from.y, from.z};
        int best = 0;
        double distance = 0;
        for (int i = 0; i < 3; i++) {
            double outside = Math.max(low[i] - at[i], at[i] - high[i]);
            if (outside > distance) {
                best = i;
                distance = outside;
            }
        }
        double[] corner = low.clone();
        corner[best] = at[best] > high[best] ? high[best] : low[best];
        Vector3[] axes = {Vector3.UNIT_X, Vector3.UNIT_Y, Vector3.UNIT_Z};
        int u = best == 0 ? 1 : 0;
        int v = best == 2 ? 1 : 2;
        return new PlaneChart(
                from,
                new Vector3(corner[0] - at[0], corner[1] - at[1], corner[2] - at[2]),
                axes[u].times(high[u] - low[u]),
                axes[v].times(high[v] - low[v]));
    }

    private boolean isParallel() {
        return light.spread() == Light.Spread.PARALLEL;
    }

    /** The rectangle across the rays that the window's box fits in. */
    private EmissionChart parallelChart(LightPoint from) {
        Vector3 direction = new Vector3(from.normalX, from.normalY, from.normalZ);
        Vector3 u = View.uprightAcross(direction);
        Vector3 v = direction.cross(u);
        Vector3 centre = window.bounds().centre();
        double halfU = window.halfExtent(u);
        double halfV = window.halfExtent(v);
        Vector3 corner = centre.minus(direction.times(startDistance))
                .minus(u.times(halfU))
                .minus(v.times(halfV));
        return new ParallelChart(direction, corner, u.times(2 * halfU), v.times(2 * halfV));
    }
}
