package org.diacaustic.preprocess;

import org.diacaustic.map.CausticMesh;
import org.diacaustic.map.Footprint;
import org.diacaustic.map.FootprintLookup;
import org.diacaustic.map.StoredCells;
import org.diacaustic.map.SurfacePoint;
import org.diacaustic.math.Rgb;
import org.diacaustic.math.Vector3;
import org.diacaustic.parallel.Workers;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;

/** The caustic mesh of a scene, asked by footprints that a test lays on its surfaces. */
final class MeshLight {
    private final MeshPass pass;
    private final Rgb total;
    private final FootprintLookup fine;
    private final FootprintLookup coarse;

    private MeshLight(MeshPass pass) {
        Workers workers = new Workers(2);
        this.pass = pass;
        this.total = StoredCells.power(pass.cells());
        this.fine = CausticMesh.movedFrom(pass.cells(), workers).lookup();
        this.coarse = CausticMesh.movedFrom(pass.largeCells(), workers).lookup();
    }

    static MeshLight of(Scene scene, Settings settings, String preProcessor, long rays) {
        return new MeshLight(pass(scene, settings, preProcessor, rays, 2));
    }

    static MeshPass pass(Scene scene, Settings settings, String preProcessor, long rays, int threads) {
        ForwardPlan plan = Forward.plan(scene, settings, preProcessor, rays);
        return new MeshPass(plan, 0, new Workers(threads), part -> {}).run();
    }

    EnergyLedger ledger() {
        return pass.ledger();
    }

    ForwardCounters counters() {
        return pass.counters();
    }

    /** The power of all cells, in W. */
    Rgb total() {
        return total;
    }

    /** The mean green irradiance in a footprint, which is closed here. */
    double irradiance(Footprint footprint) {
        return ask(fine, footprint);
    }

    /** The same of cells twice as large. */
    double coarseIrradiance(Footprint footprint) {
        return ask(coarse, footprint);
    }

    private static double ask(FootprintLookup lookup, Footprint footprint) {
        if (!footprint.close()) {
            throw new AssertionError("a footprint that cannot be closed");
        }
        Rgb irradiance = new Rgb();
        lookup.irradiance(footprint, new SurfacePoint(), irradiance);
        return irradiance.green;
    }

    /** A rectangle on the upper side of an object at height y, seen from straight above. */
    static Footprint above(int object, double y, double lowX, double lowZ, double highX, double highZ) {
        return polygon(
                on(object, true, Vector3.UNIT_Y),
                Vector3.UNIT_Y.negated(),
                new Vector3(lowX, y, lowZ),
                new Vector3(highX, y, lowZ),
                new Vector3(highX, y, highZ),
                new Vector3(lowX, y, highZ));
    }

    /** A place of no importance on a side of an object, where the normal towards the eye is this. */
    static SurfacePoint on(int object, boolean front, Vector3 normal) {
        SurfacePoint at = new SurfacePoint();
        at.object = object;
        at.front = front;
        at.normalX = normal.x();
        at.normalY = normal.y();
        at.normalZ = normal.z();
        return at;
    }

    /** A polygon on a flat surface, seen along one direction. */
    static Footprint polygon(SurfacePoint on, Vector3 direction, Vector3... corners) {
        Footprint footprint = new Footprint();
        footprint.begin(on);
        for (Vector3 corner : corners) {
            footprint.addCorner(corner.x(), corner.y(), corner.z(), direction.x(), direction.y(), direction.z());
        }
        return footprint;
    }
}
