package org.diacaustic.scenefile;

import java.util.Arrays;
import org.diacaustic.math.Vector3;
import org.diacaustic.scene.Camera;

/** Reads {@code camera}. */
final class CameraReader {
    private CameraReader() {}

    static Camera read(MappingReader in) {
        Vector3 from = in.vector3("from").required();
        Vector3 to = in.vector3("to").required();
        Vector3 up = in.direction("up").or(Vector3.UNIT_Y);
        double fieldOfView =
                in.number("field-of-view").above(0).below(180).in("degrees").or(40.0);
        double[] size = in.numbers("size", 2).or(new double[] {200, 200});
        double lensRadius = in.number("lens-radius").atLeast(0).or(0.0);
        double focus = in.number("focus-distance").above(0).or(Double.NaN);
        if (!isPixelCount(size[0]) || !isPixelCount(size[1])) {
            in.error(
                    "size",
                    "expected a width and a height in whole pixels of at least 1, found " + Arrays.toString(size));
        }
        return Building.of(in, () -> {
            Camera.Builder camera = Camera.builder()
                    .from(from)
                    .to(to)
                    .up(up)
                    .fieldOfView(fieldOfView)
                    .size((int) size[0], (int) size[1]);
            double distance = Double.isNaN(focus) ? to.minus(from).length() : focus;
            return (lensRadius > 0 ? camera.lens(lensRadius, distance) : camera).build();
        });
    }

    private static boolean isPixelCount(double side) {
        return side == Math.rint(side) && side >= 1 && side <= Integer.MAX_VALUE;
    }
}
