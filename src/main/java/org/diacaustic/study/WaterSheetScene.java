package org.diacaustic.study;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.diacaustic.image.WholeFile;

/**
 * A scene too large to be kept with the others: light through a sheet of water of 131,072 triangles, smooth between them,
 * onto a floor and an opaque ball on it. Three waves cross, so steep that their light folds before it reaches the floor.
 */
public final class WaterSheetScene {
    private static final int CELLS = 256;
    private static final double HALF = 3;
    private static final double LEVEL = 2.5;

    /** Direction x and z (not normalised), wave length, height. */
    private static final double[][] WAVES = {
        {1, 0.35, 1.45, 0.075},
        {-0.6, 1, 1.1, 0.045},
        {0.25, -1, 2.1, 0.12}
    };

    private WaterSheetScene() {}

    /**
     * Writes {@code water-sheet.yaml} and {@code water-sheet.obj}.
     *
     * @param folder made if it is not there
     * @return the scene file
     * @throws IOException if that fails
     */
    public static Path write(Path folder) throws IOException {
        Files.createDirectories(folder);
        write(folder.resolve("water-sheet.obj"), mesh(CELLS));
        Path scene = folder.resolve("water-sheet.yaml");
        try (var in = WaterSheetScene.class.getResourceAsStream("water-sheet.yaml")) {
            write(scene, new String(in.readAllBytes(), StandardCharsets.UTF_8));
        }
        return scene;
    }

    private static void write(Path file, String text) throws IOException {
        WholeFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }

    /** The sheet as OBJ, with so many cells of two triangles along a side; its normals point up. */
    static String mesh(int cells) {
        StringBuilder text = new StringBuilder("# A sheet of water: three waves that cross.\n");
        for (int row = 0; row <= cells; row++) {
            for (int column = 0; column <= cells; column++) {
                double x = HALF * (2.0 * column / cells - 1);
                double z = HALF * (2.0 * row / cells - 1);
                text.append(String.format(Locale.ROOT, "v %.6f %.6f %.6f", x, height(x, z), z))
                        .append('\n');
            }
        }
        for (int row = 0; row < cells; row++) {
            for (int column = 0; column < cells; column++) {
                int corner = row * (cells + 1) + column + 1;
                int below = corner + cells + 1;
                text.append("f ").append(corner).append(' ').append(below).append(' ');
                text.append(below + 1).append("\nf ").append(corner).append(' ');
                text.append(below + 1).append(' ').append(corner + 1).append('\n');
            }
        }
        return text.toString();
    }

    private static double height(double x, double z) {
        double height = LEVEL;
        for (double[] wave : WAVES) {
            double along = (wave[0] * x + wave[1] * z) / StrictMath.hypot(wave[0], wave[1]);
            height += wave[3] * StrictMath.sin(2 * Math.PI * along / wave[2]);
        }
        return height;
    }
}
