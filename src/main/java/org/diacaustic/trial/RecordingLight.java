package org.diacaustic.trial;

import org.diacaustic.light.Light;
import org.diacaustic.light.LightPoint;
import org.diacaustic.light.LightSample;
import org.diacaustic.math.Rgb;

/** A light that tells of every ray that is sent from it; for passes of one thread. */
final class RecordingLight implements Light {
    private final Light light;
    private Listener listener = (point, dx, dy, dz, intensity) -> {};

    RecordingLight(Light light) {
        this.light = light;
    }

    /** Tells of rays from now on: those before were a plan's, which only looks. */
    void tell(Listener to) {
        listener = to;
    }

    @Override
    public boolean sample(double x, double y, double z, double s, double t, LightSample sample) {
        return light.sample(x, y, z, s, t, sample);
    }

    @Override
    public boolean isVisible() {
        return light.isVisible();
    }

    @Override
    public int sampleCount() {
        return light.sampleCount();
    }

    @Override
    public Spread spread() {
        return light.spread();
    }

    @Override
    public void emitFrom(double s, double t, LightPoint point) {
        light.emitFrom(s, t, point);
    }

    @Override
    public void emit(LightPoint point, double dx, double dy, double dz, Rgb intensity) {
        light.emit(point, dx, dy, dz, intensity);
        listener.sent(point, dx, dy, dz, intensity.green);
    }

    /** Hears of rays. */
    @FunctionalInterface
    interface Listener {
        /** @param intensity in W·sr⁻¹, of the green channel */
        void sent(LightPoint point, double dx, double dy, double dz, double intensity);
    }
}
