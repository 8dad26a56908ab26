package org.diacaustic.reproduction;

import java.util.Optional;

/**
 * One number of a table: the thesis' and ours.
 *
 * @param published nothing in columns that only we have
 * @param remark why the published number is out of reach, if it is
 */
record Cell(Quantity quantity, Optional<Double> published, Statistic ours, Optional<PublishedTable.Remark> remark) {

    /** Ours, with as many decimals as the thesis prints. */
    double rounded() {
        double scale = Math.pow(10, quantity.decimals());
        return Math.rint(ours.mean() * scale) / scale;
    }

    /** How far ours lies from the published number, relative to it; nothing if there is none. */
    Optional<Double> difference() {
        return published.map(value -> value == rounded() ? 0.0 : (rounded() - value) / value);
    }

    /** How many standard deviations of a single run lie between; nothing if ours does not spread, or is a percentage. */
    Optional<Double> deviations() {
        double spread = ours.deviation();
        // Percentages are printed too roughly to tell.
        return spread > 0 && !quantity.isPercentage()
                ? published.map(value -> Math.abs(value - ours.mean()) / spread)
                : Optional.empty();
    }
}
