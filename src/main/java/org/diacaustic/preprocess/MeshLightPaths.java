package org.diacaustic.preprocess;

import java.util.List;
import org.diacaustic.light.Light;
import org.diacaustic.map.CellSeed;
import org.diacaustic.map.LightPaths;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Rgb;

/**
 * The light rays between those of a mesh pass. Places of a cell are those of the flat triangle that its corner rays span: charts
 * have creases, but across this triangle rays change smoothly, and how much of light space it stands for is known in closed form.
 * Owned by one task.
 */
final class MeshLightPaths implements LightPaths {
    private final List<MeshLattice> lattices;
    private final WayTracer tracer;
    private final LightRay a = new LightRay();
    private final LightRay b = new LightRay();
    private final LightRay c = new LightRay();
    private final LightRay ray = new LightRay();
    private MeshLattice lattice;
    private boolean isParallel;
    private long path;

    /** The sides of the triangle, from the first corner: of directions, or, of parallel rays, of origins. */
    private double bx;

    private double by;
    private double bz;
    private double cx;
    private double cy;
    private double cz;

    /** Of the body that directions to the triangle's sides span, or, of parallel rays, of the sides alone. */
    private double volume;

    /** @param lattices of the pass, in order */
    MeshLightPaths(List<MeshLattice> lattices, WayTracer tracer) {
        this.lattices = lattices;
        this.tracer = tracer;
    }

    @Override
    public void enter(CellSeed cell) {
        lattice = lattices.get(cell.chart);
        path = cell.path;
        isParallel = lattice.beam().light().spread() == Light.Spread.PARALLEL;
        lattice.chart().aim(cell.p0, cell.q0, a);
        lattice.chart().aim(cell.p1, cell.q1, b);
        lattice.chart().aim(cell.p2, cell.q2, c);
        bx = isParallel ? b.originX - a.originX : b.directionX - a.directionX;
        by = isParallel ? b.originY - a.originY : b.directionY - a.directionY;
        bz = isParallel ? b.originZ - a.originZ : b.directionZ - a.directionZ;
        cx = isParallel ? c.originX - a.originX : c.directionX - a.directionX;
        cy = isParallel ? c.originY - a.originY : c.directionY - a.directionY;
        cz = isParallel ? c.originZ - a.originZ : c.directionZ - a.directionZ;
        volume = Math.abs(a.directionX * (by * cz - bz * cy)
                + a.directionY * (bz * cx - bx * cz)
                + a.directionZ * (bx * cy - by * cx));
    }

    @Override
    public boolean follow(double s, double t, SurfacePoint at, Rgb power) {
        if (!tracer.follow(lattice.beam(), lattice.point(), aimed(s, t), path, at, power)) {
            return false;
        }
        power.scale(ray.measure * lattice.pointShare());
        return true;
    }

    /** The ray of a place; its measure is how much of light space a unit of (s, t) stands for. */
    private LightRay aimed(double s, double t) {
        double x = s * bx + t * cx;
        double y = s * by + t * cy;
        double z = s * bz + t * cz;
        if (isParallel) {
            ray.setOrigin(a.originX + x, a.originY + y, a.originZ + z);
            ray.setDirection(a.directionX, a.directionY, a.directionZ);
            ray.measure = volume;
            return ray;
        }
        x += a.directionX;
        y += a.directionY;
        z += a.directionZ;
        double distanceSquared = x * x + y * y + z * z;
        ray.setOrigin(a.originX, a.originY, a.originZ);
        ray.setDirection(x, y, z);
        ray.measure = volume / (distanceSquared * Math.sqrt(distanceSquared));
        return ray;
    }
}
