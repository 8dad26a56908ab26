package org.diacaustic.shape;

import org.diacaustic.math.Arithmetic;
import org.diacaustic.math.Ray;

/**
 * Where a ray met a surface: filled in once, for the nearest hit only, by {@link Shape#complete}. Mutable and owned by
 * one task. All normals point outward and have length 1.
 */
public final class Hit {
    private static final double TOUCHING_ERRORS = 8;

    /** Lines flatter than this to the surface are not followed farther to find what touches it. */
    private static final double FLATTEST = 0x1p-10;

    /** The distance along the ray, in lengths of its direction. */
    public double t;

    public double x;
    public double y;
    public double z;

    /** How far the computed point may lie off the surface, in scene units. */
    public double pointError;

    /** The normal of the surface as it is. */
    public double normalX;

    public double normalY;
    public double normalZ;

    /** The normal to shade with: the surface's own, interpolated between vertices, or bumped. */
    public double shadingX;

    public double shadingY;
    public double shadingZ;

    /** The primitive of the shape that was hit: a triangle of a mesh, a sphere of a flake; 0 for single shapes. */
    public int primitive;

    /** What the shape noted with the hit, such as barycentric coordinates; see {@code Ray.hitU}. */
    public double noteU;

    public double noteV;

    /** Map coordinates in 0..1, after {@link Shape#inverseMap}. */
    public double u;

    public double v;

    /** How the point moves with u and with v, after {@link Shape#inverseMap}; zero where that is not defined. */
    public double tangentUX;

    public double tangentUY;
    public double tangentUZ;
    public double tangentVX;
    public double tangentVY;
    public double tangentVZ;

    /** Takes over what the ray noted of its nearest hit, before {@link Shape#complete}. */
    public void take(Ray ray) {
        t = ray.tMax;
        primitive = ray.hitPrimitive;
        noteU = ray.hitU;
        noteV = ray.hitV;
    }

    /** Takes over point and normals of another hit. */
    public void copyPlace(Hit other) {
        setPoint(other.x, other.y, other.z, other.pointError);
        normalX = other.normalX;
        normalY = other.normalY;
        normalZ = other.normalZ;
        shadingX = other.shadingX;
        shadingY = other.shadingY;
        shadingZ = other.shadingZ;
    }

    /**
     * How far before or behind this point, along a line at the given cosine to the normal, surfaces are found that touch
     * this one here: a few rounding errors of this surface and of its coordinates.
     */
    public double touchingDistance(double cosine) {
        double rounding = Arithmetic.UNIT_ROUNDOFF * (Math.abs(x) + Math.abs(y) + Math.abs(z));
        return TOUCHING_ERRORS * (pointError + rounding) / Math.max(Math.abs(cosine), FLATTEST);
    }

    public void setPoint(double px, double py, double pz, double error) {
        x = px;
        y = py;
        z = pz;
        pointError = error;
    }

    /** Sets the geometric and the shading normal alike. */
    public void setNormal(double nx, double ny, double nz) {
        normalX = nx;
        normalY = ny;
        normalZ = nz;
        shadingX = nx;
        shadingY = ny;
        shadingZ = nz;
    }

    /** Makes the normals point the other way. */
    void turnNormals() {
        normalX = -normalX;
        normalY = -normalY;
        normalZ = -normalZ;
        shadingX = -shadingX;
        shadingY = -shadingY;
        shadingZ = -shadingZ;
    }

    public void setMap(double mapU, double mapV) {
        u = mapU;
        v = mapV;
    }

    public void setTangents(double ux, double uy, double uz, double vx, double vy, double vz) {
        tangentUX = ux;
        tangentUY = uy;
        tangentUZ = uz;
        tangentVX = vx;
        tangentVY = vy;
        tangentVZ = vz;
    }
}
