package org.diacaustic.study;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.diacaustic.scene.Scene;
import org.diacaustic.scenefile.Problems;
import org.diacaustic.scenefile.SceneReader;
import org.diacaustic.shape.TriangleMesh;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WaterSheetSceneTest {

    @Test
    void mesh_givenOneCell_isTwoTrianglesThatFaceUp() {
        assertThat(WaterSheetScene.mesh(1).lines().filter(line -> line.startsWith("f")))
                .containsExactly("f 1 3 4", "f 1 4 2");
        assertThat(WaterSheetScene.mesh(1).lines().filter(line -> line.startsWith("v")))
                .hasSize(4)
                .first()
                .asString()
                .startsWith("v -3.000000 2.")
                .endsWith(" -3.000000");
    }

    @Test
    void write_givenAFolder_makesASceneThatCanBeRead(@TempDir Path folder) throws IOException {
        Path file = WaterSheetScene.write(folder.resolve("scenes"));
        Problems problems = new Problems();
        Scene scene = SceneReader.read(file, problems)
                .orElseThrow(() -> new AssertionError(problems))
                .scene();
        assertThat(problems.toString()).isEmpty();
        assertThat(scene.objects().get(2).shape()).isInstanceOf(TriangleMesh.class);
        // Water lies below, where the floor is.
        assertThat(scene.objects().get(2).material().inside().indexOfRefraction())
                .isEqualTo(1.33);
    }
}
