package org.diacaustic.study;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.diacaustic.chart.Ink;
import org.diacaustic.chart.SvgCanvas;
import org.diacaustic.image.WholeFile;
import org.diacaustic.map.Cell;
import org.diacaustic.map.CellSeed;
import org.diacaustic.map.CellStore;
import org.diacaustic.parallel.Workers;
import org.diacaustic.preprocess.ForwardPlan;
import org.diacaustic.preprocess.MeshPass;
import org.diacaustic.render.PlanException;
import org.diacaustic.render.RenderPlan;
import org.diacaustic.scene.Scene;
import org.diacaustic.scenefile.SceneFile;

/**
 * The cells of a caustic mesh, drawn: to the left in light space, on the chart that holds the most light; to the right where they
 * land, as the camera would see them if nothing stood before them. Cells that came the same way have one colour; of all ways,
 * the brightest few are drawn.
 */
public final class CellsChart {
    private static final int SIDE = 320;
    private static final int GAP = 20;
    private static final int TOP = 24;

    /** Steps of a unit of the drawing to which corners are rounded: short numbers make a small file. */
    private static final int STEPS = 8;

    private static final List<String> COLORS = List.of("#dc7c26", "#266fb3", "#3f8f5b");

    private final PinholeView view;
    private final double scale;
    private final List<Cell> cells = new ArrayList<>();
    private final List<Long> ways = new ArrayList<>();
    private final StringBuilder drawing = new StringBuilder();

    private CellsChart(Scene scene, CellStore store) {
        view = new PinholeView(scene.camera());
        scale = (double) SIDE / Math.max(scene.camera().width(), scene.camera().height());
        int chart = brightestChart(store);
        Map<Long, Double> powers = new HashMap<>();
        for (int i = 0; i < store.size(); i++) {
            Cell cell = new Cell();
            store.read(i, cell);
            if (cell.hasSeed && cell.seed.chart == chart) {
                cells.add(cell);
                powers.merge(cell.seed.path, cell.power.sum(), Double::sum);
            }
        }
        powers.entrySet().stream()
                .sorted(Map.Entry.<Long, Double>comparingByValue().reversed().thenComparing(Map.Entry.comparingByKey()))
                .limit(COLORS.size())
                .forEach(entry -> ways.add(entry.getKey()));
    }

    private static int brightestChart(CellStore store) {
        Map<Integer, Double> powers = new HashMap<>();
        Cell cell = new Cell();
        for (int i = 0; i < store.size(); i++) {
            store.read(i, cell);
            if (cell.hasSeed) {
                powers.merge(cell.seed.chart, cell.power.sum(), Double::sum);
            }
        }
        return powers.entrySet().stream()
                .max(Map.Entry.<Integer, Double>comparingByValue().thenComparing(Map.Entry.comparingByKey()))
                .map(Map.Entry::getKey)
                .orElse(-1);
    }

    /**
     * Draws {@code cells.svg} into a folder, which is made if it is not there.
     *
     * @param rays light rays of the mesh, about; more than some hundreds are hard to see
     * @throws IOException if the scene cannot be read, or the drawing not written
     * @throws PlanException if the scene has no caustic mesh, or the camera a lens, through which a point is seen in many places
     */
    public static Path write(SceneSource source, long rays, int threads, Path folder) throws IOException {
        SceneFile file = source.read(Map.of("map", "caustic-mesh", "rays", Long.toString(rays)));
        if (file.scene().camera().lensRadius() > 0) {
            throw new PlanException("cells are drawn as a pinhole camera sees them, but this one has a lens-radius of "
                    + file.scene().camera().lensRadius());
        }
        ForwardPlan plan = RenderPlan.of(file.scene(), file.settings())
                .forward()
                .orElseThrow(() -> new PlanException("nothing in the scene refracts or mirrors light onto a surface"));
        MeshPass pass = new MeshPass(plan, 0, new Workers(threads), part -> {}).keepingSeeds();
        String svg = new CellsChart(file.scene(), pass.run().cells()).svg();
        Files.createDirectories(folder);
        Path target = folder.resolve("cells.svg");
        WholeFile.write(target, out -> out.write(svg.getBytes(StandardCharsets.UTF_8)));
        return target;
    }

    private String svg() {
        int width = 2 * SIDE + 3 * GAP;
        int height = SIDE + TOP + GAP;
        SvgCanvas canvas = new SvgCanvas(width, height, "cells in light space, and where they land");
        canvas.fill(0, 0, width, height, Ink.PAPER);
        canvas.text(GAP, TOP - 8, "light space");
        canvas.text(SIDE + 2.0 * GAP, TOP - 8, "where it lands");
        canvas.outline(GAP, TOP, SIDE, SIDE, Ink.GRID);
        canvas.outline(SIDE + 2.0 * GAP, TOP, SIDE, SIDE, Ink.GRID);
        drawLightSpace(canvas);
        drawLanded(canvas);
        return canvas.file();
    }

    /** A triangle that light left in many ways is drawn once. */
    private void drawLightSpace(SvgCanvas canvas) {
        Set<String> triangles = new LinkedHashSet<>();
        for (Cell cell : cells) {
            CellSeed seed = cell.seed;
            triangles.add(triangle(seed.p0, seed.q0, seed.p1, seed.q1, seed.p2, seed.q2, SIDE));
        }
        canvas.beginClip(GAP, TOP, SIDE, SIDE, 1.0 / STEPS);
        canvas.path(String.join("", triangles), Ink.TEXT.webColor);
        canvas.endClip();
    }

    private void drawLanded(SvgCanvas canvas) {
        canvas.beginClip(SIDE + 2.0 * GAP, TOP, SIDE, SIDE, 1.0 / STEPS);
        // The brightest last, above the others.
        for (int way = ways.size() - 1; way >= 0; way--) {
            drawing.setLength(0);
            for (Cell cell : cells) {
                if (cell.seed.path == ways.get(way)) {
                    drawing.append(landed(cell.vertices));
                }
            }
            canvas.path(drawing.toString(), COLORS.get(way));
        }
        canvas.endClip();
    }

    /** The triangle as it is seen; nothing if a part of it is not before the eye. */
    private String landed(double[] v) {
        double x0 = view.column(v[0], v[1], v[2]);
        double x1 = view.column(v[3], v[4], v[5]);
        double x2 = view.column(v[6], v[7], v[8]);
        if (Double.isNaN(x0 + x1 + x2)) {
            return "";
        }
        double y0 = view.row(v[0], v[1], v[2]);
        double y1 = view.row(v[3], v[4], v[5]);
        double y2 = view.row(v[6], v[7], v[8]);
        return triangle(x0, y0, x1, y1, x2, y2, scale);
    }

    private static String triangle(
            double x0, double y0, double x1, double y1, double x2, double y2, double unitsAStep) {
        double steps = unitsAStep * STEPS;
        long x = Math.round(steps * x0);
        long y = Math.round(steps * y0);
        long nextX = Math.round(steps * x1);
        long nextY = Math.round(steps * y1);
        return String.format(
                Locale.ROOT,
                "M%d %dl%d %d %d %dz",
                x,
                y,
                nextX - x,
                nextY - y,
                Math.round(steps * x2) - nextX,
                Math.round(steps * y2) - nextY);
    }
}
