package org.diacaustic.preprocess;

import org.diacaustic.math.CompensatedSum;
import org.diacaustic.math.Rgb;

/**
 * Where the flux of the light rays went, in W, the three colours summed: emitted = stored + absorbed + escaped + cut. The
 * flux that a surface keeps is stored if a photon was put there, otherwise absorbed.
 */
public final class EnergyLedger {
    private final CompensatedSum emitted = new CompensatedSum();
    private final CompensatedSum stored = new CompensatedSum();
    private final CompensatedSum absorbed = new CompensatedSum();
    private final CompensatedSum escaped = new CompensatedSum();
    private final CompensatedSum cut = new CompensatedSum();

    EnergyLedger() {}

    void add(EnergyLedger other) {
        emitted.add(other.emitted());
        stored.add(other.stored());
        absorbed.add(other.absorbed());
        escaped.add(other.escaped());
        cut.add(other.cut());
    }

    void emit(Rgb flux) {
        add(emitted, flux);
    }

    void store(Rgb flux) {
        add(stored, flux);
    }

    void absorb(Rgb flux) {
        add(absorbed, flux);
    }

    void escape(Rgb flux) {
        add(escaped, flux);
    }

    void cut(Rgb flux) {
        add(cut, flux);
    }

    /** Adds to an account of {@link LeafTracer}. */
    void add(int account, double flux) {
        CompensatedSum sum = switch (account) {
            case LeafTracer.EMITTED -> emitted;
            case LeafTracer.STORED -> stored;
            case LeafTracer.ABSORBED -> absorbed;
            case LeafTracer.ESCAPED -> escaped;
            default -> cut;
        };
        sum.add(flux);
    }

    private static void add(CompensatedSum sum, Rgb flux) {
        sum.add(flux.red);
        sum.add(flux.green);
        sum.add(flux.blue);
    }

    /**
     * Sent out by the light rays that counted. How much light goes past everything or meets only matt surfaces depends on where
     * rays are aimed, so compare it with the other sums, not between pre-processors.
     */
    public double emitted() {
        return emitted.value();
    }

    /** Kept by surfaces where photons were stored. */
    public double stored() {
        return stored.value();
    }

    /** Kept by other surfaces and by media. */
    public double absorbed() {
        return absorbed.value();
    }

    /** Gone where there is nothing more to meet. */
    public double escaped() {
        return escaped.value();
    }

    /** Not followed: too weak, too often mirrored or refracted, or left out by a choice of the settings. */
    public double cut() {
        return cut.value();
    }
}
