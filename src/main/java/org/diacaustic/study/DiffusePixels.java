package org.diacaustic.study;

import java.util.BitSet;
import org.diacaustic.image.ImageMask;
import org.diacaustic.image.LinearImage;
import org.diacaustic.material.Material;
import org.diacaustic.scene.Camera;
import org.diacaustic.scene.Scene;
import org.diacaustic.scene.SceneIndex;

/**
 * The pixels that show nothing but one side of one diffuse object that neither mirrors nor lets light through: the eye rays
 * through the middle and the four corners all meet it first.
 */
final class DiffusePixels implements ImageMask {
    private static final int NOT_DIFFUSE = -1;

    private final int width;
    private final int height;
    private final BitSet included;

    private DiffusePixels(int width, int height, BitSet included) {
        this.width = width;
        this.height = height;
        this.included = included;
    }

    /** Looks through a pinhole: a lens is taken for its middle. */
    static DiffusePixels of(Scene scene) {
        Camera camera = scene.camera();
        SceneIndex index = SceneIndex.of(scene.objects(), false);
        FirstSurface first = new FirstSurface(scene, index);
        int width = camera.width();
        int[] above = null;
        BitSet included = new BitSet();
        for (int y = 0; y <= camera.height(); y++) {
            int[] below = new int[width + 1];
            for (int x = 0; x <= width; x++) {
                below[x] = seen(x, y, camera, index, first);
            }
            for (int x = 0; x < width && above != null; x++) {
                int corner = above[x];
                if (corner != NOT_DIFFUSE
                        && corner == above[x + 1]
                        && corner == below[x]
                        && corner == below[x + 1]
                        && corner == seen(x + 0.5, y - 0.5, camera, index, first)) {
                    included.set((y - 1) * width + x);
                }
            }
            above = below;
        }
        return new DiffusePixels(width, camera.height(), included);
    }

    /** The object and its side as one number, or {@link #NOT_DIFFUSE}. */
    private static int seen(double x, double y, Camera camera, SceneIndex index, FirstSurface first) {
        camera.aim(x, y, 0, 0, first.ray);
        int object = first.find();
        if (object == SceneIndex.NONE) {
            return NOT_DIFFUSE;
        }
        Material material = index.object(object).material();
        boolean isDiffuse = material.isDiffuse() && !material.isReflective() && !material.isTransparent();
        return isDiffuse ? object << 1 | (first.cosine() > 0 ? 1 : 0) : NOT_DIFFUSE;
    }

    @Override
    public boolean includes(int x, int y) {
        return included.get(y * width + x);
    }

    /** White where they are, black elsewhere. */
    LinearImage picture() {
        LinearImage picture = new LinearImage(width, height);
        included.stream().forEach(pixel -> picture.set(pixel % width, pixel / width, 1, 1, 1));
        return picture;
    }

    /** How many they are. */
    int count() {
        return included.cardinality();
    }
}
