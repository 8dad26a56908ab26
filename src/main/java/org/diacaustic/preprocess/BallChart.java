package org.diacaustic.preprocess;

import java.util.Optional;
import org.diacaustic.light.LightPoint;
import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Matrix;
import org.diacaustic.math.Transform;
import org.diacaustic.math.Vector3;

/**
 * The rays from a light point at a sphere, or at what a linear transform makes of one. The square is laid concentrically on the
 * disc that the point sees [Shirley and Chiu 1997], and the disc by equal steps of the angle of incidence from its middle
 * to its rim: what a sphere does to a ray changes with the root of the distance to the rim, and so evenly.
 */
final class BallChart extends EmissionChart {
    /**
     * How far before the rim, in steps of incidence, the chart ends: rays at the very rim go by or not, by rounding. The light
     * of the rim is given to the other rays.
     */
    private static final double RIM = 0x1p-20;

    /** The largest part of the steps that may be rim: from farther away the ball is too small to be aimed at. */
    private static final double LARGEST_RIM = 0x1p-4;

    /** The rounding of a ray's distance from the middle, for a unit of the distance it starts at, with a margin. */
    private static final double ROUNDING = 0x1p-46;

    /** Of series that are right to rounding for arguments up to π. */
    private static final int TERMS = 15;

    private static final double[] SINE_RATIO = series(0);
    private static final double[] COSINE = series(1);

    private final Vector3 from;
    private final Matrix toScene;
    private final Vector3 axis;
    private final Vector3 u;
    private final Vector3 v;
    private final double distance;
    private final double widest;
    private final double withRim;
    private final double determinant;
    private final double size;
    private final boolean isSimilar;

    private BallChart(LightPoint from, Matrix toScene, Vector3 local, double determinant, boolean isSimilar) {
        this.from = new Vector3(from.x, from.y, from.z);
        this.toScene = toScene;
        this.distance = local.length();
        this.axis = local.normalized().negated();
        this.u = axis.perpendicular();
        this.v = axis.cross(u);
        this.widest = 1 - Math.max(RIM, Math.sqrt(distance * ROUNDING));
        this.withRim = versine(1 / distance) / versine(StrictMath.sin(step(1)) / distance);
        this.determinant = determinant;
        this.size = StrictMath.cbrt(determinant);
        this.isSimilar = isSimilar;
    }

    /**
     * The chart of a ball as a point sees it; empty if the point is inside, or so near or so far away that rounding
     * matters.
     *
     * @param toScene the transform of the unit ball about the origin
     */
    static Optional<EmissionChart> of(LightPoint from, Transform toScene) {
        Vector3 local = toScene.inversePoint(new Vector3(from.x, from.y, from.z));
        Vector3 x = toScene.vector(Vector3.UNIT_X);
        Vector3 y = toScene.vector(Vector3.UNIT_Y);
        Vector3 z = toScene.vector(Vector3.UNIT_Z);
        double determinant = Math.abs(x.dot(y.cross(z)));
        boolean isOutside = local.isFinite()
                && local.length() > 1 + 0x1p-10
                && local.length() * ROUNDING < LARGEST_RIM * LARGEST_RIM
                && determinant > 0;
        boolean isSimilar = y.equals(new Vector3(0, x.x(), 0)) && z.equals(new Vector3(0, 0, x.x()));
        return isOutside
                ? Optional.of(new BallChart(from, toScene.linear(), local, determinant, isSimilar))
                : Optional.empty();
    }

    @Override
    public void aim(double p, double q, LightRay ray) {
        double a = 2 * p - 1;
        double b = 2 * q - 1;
        boolean wide = Math.abs(a) > Math.abs(b);
        double radius = wide ? a : b;
        double angle = radius == 0 ? 0 : Math.PI / 4 * (wide ? b / a : a / b);
        double along = StrictMath.cos(angle);
        double across = StrictMath.sin(angle);
        double sine = StrictMath.sin(step(radius)) / distance;
        double cosine = Math.sqrt((1 - sine) * (1 + sine));
        double s = sine * (wide ? along : across);
        double t = sine * (wide ? across : along);
        double x = cosine * axis.x() + s * u.x() + t * v.x();
        double y = cosine * axis.y() + s * u.y() + t * v.y();
        double z = cosine * axis.z() + s * u.z() + t * v.z();
        ray.setOrigin(from.x(), from.y(), from.z());
        ray.setDirection(toScene.timesX(x, y, z), toScene.timesY(x, y, z), toScene.timesZ(x, y, z));
        ray.measure = densityOfBall(radius) * stretch(x, y, z);
    }

    /** The angle of incidence. */
    private double step(double radius) {
        return widest * (Math.PI / 2) * radius;
    }

    @Override
    public double density(double p, double q) {
        double a = 2 * p - 1;
        double b = 2 * q - 1;
        double radius = Math.max(Math.abs(a), Math.abs(b));
        if (isSimilar) {
            return densityOfBall(radius);
        }
        LightRay ray = new LightRay();
        aim(p, q, ray);
        return ray.measure;
    }

    /** The solid angle that the transform makes of a unit of it. */
    private double stretch(double x, double y, double z) {
        if (isSimilar) {
            return 1;
        }
        double length = Arithmetic.length(toScene.timesX(x, y, z), toScene.timesY(x, y, z), toScene.timesZ(x, y, z));
        return determinant / (length * length * length);
    }

    /** sinθ · dθ · dφ in the space where the ball is round, for dp · dq. */
    private double densityOfBall(double radius) {
        double widestStep = step(1);
        double twice = 2 * step(radius);
        double square = twice * twice;
        double sine = Math.sqrt(0.5 * (1 - evenSeries(COSINE, square))) / distance;
        double cosine = Math.sqrt((1 - sine) * (1 + sine));
        return withRim
                * (Math.PI * widestStep * widestStep * evenSeries(SINE_RATIO, square) / (distance * distance * cosine));
    }

    /** 1 − cos of the angle of a sine. */
    private static double versine(double sine) {
        return sine * sine / (1 + Math.sqrt((1 - sine) * (1 + sine)));
    }

    private static double evenSeries(double[] coefficients, double square) {
        double sum = 0;
        for (int i = coefficients.length - 1; i >= 0; i--) {
            sum = Math.fma(sum, square, coefficients[i]);
        }
        return sum;
    }

    /** The series of sin(x + k·π/2) ÷ x^(1 − k) in x²: of sin x ÷ x for k = 0, of cos x for k = 1. */
    private static double[] series(int k) {
        double[] coefficients = new double[TERMS];
        double term = 1;
        for (int i = 0; i < TERMS; i++) {
            coefficients[i] = term;
            term /= -(2 * i + 2.0 - k) * (2 * i + 3.0 - k);
        }
        return coefficients;
    }

    @Override
    public double width() {
        return size;
    }

    @Override
    public double height() {
        return size;
    }
}
