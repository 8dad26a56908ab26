package org.diacaustic.trial;

import org.diacaustic.image.LinearImage;
import org.diacaustic.preprocess.EnergyLedger;
import org.diacaustic.render.RenderJob;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.render.Rendering;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.Settings;

/** Renders on one thread, and compares what comes. */
final class Pictures {
    private Pictures() {}

    static Rendering render(Scene scene, Settings settings) {
        return render(scene, settings, 1);
    }

    static Rendering render(Scene scene, Settings settings, int threads) {
        return new RenderJob(RenderPlan.of(scene, settings), threads, (done, total) -> {}).run();
    }

    /** How many pixels differ in any bit. */
    static int different(LinearImage a, LinearImage b) {
        int count = 0;
        for (int i = 0; i < a.samples().length; i += 3) {
            boolean same = true;
            for (int k = i; k < i + 3; k++) {
                same &= Float.floatToRawIntBits(a.samples()[k]) == Float.floatToRawIntBits(b.samples()[k]);
            }
            count += same ? 0 : 1;
        }
        return count;
    }

    /** How many pixels differ by more than a fraction of the larger. */
    static int different(LinearImage a, LinearImage b, double fraction) {
        int count = 0;
        for (int i = 0; i < a.samples().length; i += 3) {
            boolean same = true;
            for (int k = i; k < i + 3; k++) {
                same &= !isApart(a.samples()[k], b.samples()[k], fraction);
            }
            count += same ? 0 : 1;
        }
        return count;
    }

    /**
     * How many pixels that are not at an edge differ by more than a fraction of the larger; at an edge are those of a border,
     * and those of which a neighbour's light differs by more than a tenth.
     */
    static int differentInside(LinearImage a, LinearImage b, double fraction) {
        int count = 0;
        for (int y = 1; y < a.height() - 1; y++) {
            for (int x = 1; x < a.width() - 1; x++) {
                boolean differs = false;
                for (int k = a.offset(x, y); k < a.offset(x, y) + 3; k++) {
                    differs |= isApart(a.samples()[k], b.samples()[k], fraction);
                }
                count += differs && isInside(a, x, y) ? 1 : 0;
            }
        }
        return count;
    }

    private static boolean isInside(LinearImage image, int x, int y) {
        boolean inside = true;
        int at = image.offset(x, y);
        for (int i = 0; i < 9; i++) {
            int beside = image.offset(x + i % 3 - 1, y + i / 3 - 1);
            for (int k = 0; k < 3; k++) {
                inside &= !isApart(image.samples()[at + k], image.samples()[beside + k], 0.1);
            }
        }
        return inside;
    }

    private static boolean isApart(double x, double y, double fraction) {
        return !(Math.abs(x - y) <= fraction * Math.max(Math.abs(x), Math.abs(y)));
    }

    static boolean isFinite(LinearImage image) {
        boolean finite = true;
        for (float sample : image.samples()) {
            finite &= Float.isFinite(sample);
        }
        return finite;
    }

    /** |emitted − all that became of it| ÷ emitted; 0 if nothing was emitted. */
    static double gap(EnergyLedger ledger) {
        double became = ledger.stored() + ledger.absorbed() + ledger.escaped() + ledger.cut();
        return ledger.emitted() == 0 ? 0 : Math.abs(ledger.emitted() - became) / ledger.emitted();
    }
}
