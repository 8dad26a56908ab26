package org.diacaustic.trial;

import java.util.Locale;
import org.diacaustic.light.Falloff;
import org.diacaustic.light.FlatLight;
import org.diacaustic.light.Light;
import org.diacaustic.light.LightPoint;
import org.diacaustic.light.PointLight;
import org.diacaustic.light.SphereLight;
import org.diacaustic.light.SpotLight;
import org.diacaustic.math.Color;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.SampleStream;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.preprocess.ForwardPass;
import org.diacaustic.preprocess.ForwardPlan;
import org.diacaustic.stability.CaseFault;

/** The directions that rays leave a light in, in cells of equal flux about its axis. */
final class DirectionCells {
    private static final Vector3 AT = new Vector3(0, 2, 0);

    /** No axis of anything else. */
    private static final Vector3 AXIS = new Vector3(1, -2, 0.5).normalized();

    private static final double SPOT_DEGREES = 30;

    private final Light light;
    private final boolean isCosine;

    /** 1 − the cosine of the widest angle. */
    private final double versine;

    private final int rows;
    private final long[] counts;
    private final SampleStream chance = new SampleStream();

    private DirectionCells(Light light, boolean isCosine, double versine, int cells) {
        this.light = light;
        this.isCosine = isCosine;
        this.versine = versine;
        int divisor = (int) Math.sqrt(cells);
        while (cells % divisor != 0) {
            divisor--;
        }
        this.rows = divisor;
        this.counts = new long[cells];
    }

    /** @throws CaseFault if there is no light of that name */
    static DirectionCells of(String name, int cells) {
        Falloff falloff = new Falloff.InverseSquare();
        Vector3 across = AXIS.perpendicular();
        return switch (name.toLowerCase(Locale.ROOT).strip()) {
            case "point", "isotropic", "isotropic point" ->
                new DirectionCells(new PointLight(AT, Color.WHITE), false, 2, cells);
            case "spot", "spot cone" ->
                new DirectionCells(
                        new SpotLight(AT, AXIS, SPOT_DEGREES, SPOT_DEGREES, Color.WHITE, falloff, 0),
                        false,
                        1 - StrictMath.cos(StrictMath.toRadians(SPOT_DEGREES)),
                        cells);
            case "area", "cosine", "cosine area", "rectangle", "rectangle area" ->
                new DirectionCells(
                        FlatLight.rectangle(
                                AT, across.times(0.2), AXIS.cross(across).times(0.1), Color.WHITE, falloff, 1),
                        true,
                        1,
                        cells);
            case "disc", "disc area" ->
                new DirectionCells(FlatLight.disc(AT, AXIS, 0.2, Color.WHITE, falloff, 1), true, 1, cells);
            case "sphere", "sphere area" ->
                new DirectionCells(new SphereLight(AT, 0.2, Color.WHITE, falloff, 1), true, 1, cells);
            default -> throw new CaseFault("inputs.lights: how a light called '" + name + "' shines is not said");
        };
    }

    /** Sends rays, and compares the numbers in the cells with their mean. */
    double chiSquare(long rays) {
        RecordingLight recorded = new RecordingLight(light);
        ForwardPlan plan =
                LightRun.plan(LitFloor.under(1, 0.01, 1, recorded), LitFloor.everywhere(1, 1), "random", rays);
        double most = mostIntense();
        chance.start(1, 0, 0);
        recorded.tell((point, dx, dy, dz, intensity) -> {
            if (chance.nextDouble() * most < intensity) {
                counts[cell(point, dx, dy, dz)]++;
            }
        });
        new ForwardPass(plan, 0, new Workers(1)).run();
        double kept = 0;
        for (long count : counts) {
            kept += count;
        }
        double mean = kept / counts.length;
        double sum = 0;
        for (long count : counts) {
            sum += (count - mean) * (count - mean) / mean;
        }
        return sum;
    }

    /** What the light sends where it sends most. */
    private double mostIntense() {
        LightPoint point = new LightPoint();
        light.emitFrom(0.5, 0.5, point);
        Vector3 axis = axis(point);
        Rgb intensity = new Rgb();
        light.emit(point, axis.x(), axis.y(), axis.z(), intensity);
        return intensity.green;
    }

    private int cell(LightPoint point, double dx, double dy, double dz) {
        Vector3 axis = axis(point);
        Vector3 u = axis.perpendicular();
        Vector3 direction = new Vector3(dx, dy, dz);
        double cosine = direction.dot(axis);
        double part = isCosine ? 1 - cosine * cosine : (1 - cosine) / versine;
        double turn = StrictMath.atan2(direction.dot(axis.cross(u)), direction.dot(u)) / (2 * Math.PI) + 0.5;
        int columns = counts.length / rows;
        return step(part, rows) * columns + step(turn, columns);
    }

    private static int step(double part, int steps) {
        return Math.max(0, Math.min(steps - 1, (int) (part * steps)));
    }

    /** The normal of the light's surface, or its own axis. */
    private static Vector3 axis(LightPoint point) {
        Vector3 normal = new Vector3(point.normalX, point.normalY, point.normalZ);
        return normal.length() > 0 ? normal : AXIS;
    }
}
