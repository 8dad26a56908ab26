package org.diacaustic.scenefile;

import static org.assertj.core.api.Assertions.assertThat;

import de.javagl.obj.Obj;
import de.javagl.obj.ObjFace;
import de.javagl.obj.ObjReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.io.StringReader;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.diacaustic.scenefile.Problem.Severity;
import org.diacaustic.shape.MeshData;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class MeshFileTest {
    private static final String PLY_HEAD = """
            ply
            format %s 1.0
            comment made by hand
            element vertex %d
            property float x
            property float y
            property float z
            property uchar red
            element face %d
            property list uchar int vertex_indices
            end_header
            """;

    @TempDir
    Path folder;

    private final Problems problems = new Problems();

    private Optional<MeshData> read(String name, byte[] bytes) throws IOException {
        Path file = folder.resolve(name);
        Files.write(file, bytes);
        return MeshFile.read(file, problems);
    }

    private MeshData mesh(String name, String text) throws IOException {
        Optional<MeshData> mesh = read(name, text.getBytes(StandardCharsets.UTF_8));
        assertThat(problems.sorted()).isEmpty();
        return mesh.orElseThrow();
    }

    private void assertRefused(String name, byte[] bytes, String expected) throws IOException {
        assertThat(read(name, bytes)).isEmpty();
        assertThat(problems).hasToString(folder.resolve(name) + expected);
        assertThat(problems.exitCode()).isEqualTo(2);
    }

    private void assertRefused(String name, String text, String expected) throws IOException {
        assertRefused(name, text.getBytes(StandardCharsets.UTF_8), expected);
    }

    // Wavefront OBJ

    @Test
    void obj_givenTrianglesOnly_keepsVerticesAsTheyStand() throws IOException {
        MeshData mesh = mesh("a.obj", "# cup\no cup\nv 0 0 0\nv 1.5 0 0\r\nv 0 -2e-3 0.1 1.0\ns off\nf 1 2 3\n");

        assertThat(mesh.vertices()).containsExactly(0, 0, 0, 1.5, 0, 0, 0, -2e-3, 0.1);
        assertThat(mesh.triangles()).containsExactly(0, 1, 2);
        assertThat(mesh.normals()).isNull();
        assertThat(mesh.maps()).isNull();
    }

    @Test
    void obj_givenNegativeIndices_countsBackFromTheLatest() throws IOException {
        MeshData mesh = mesh("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 1 1 0\nf -2 -3 -1\n");

        assertThat(mesh.triangles()).containsExactly(0, 1, 2, 2, 1, 3);
    }

    @Test
    void obj_givenSeamsInMapsAndNormals_makesAVertexOfEachCombination() throws IOException {
        MeshData mesh = mesh("a.obj", """
                v 0 0 0
                v 1 0 0
                v 0 1 0
                v 1 1 0
                vt 0 0
                vt 1 0
                vt 0 1
                vt 0.5 0.5
                vn 0 0 1
                vn 1 0 0
                f 1/1/1 2/2/1 3/3/1
                f 2/4/2 4/1/2 3/3/1
                """);

        // Corner 3/3/1 is shared; vertex 2 comes twice, because its second use has another map and normal.
        assertThat(mesh.triangles()).containsExactly(0, 1, 2, 3, 4, 2);
        assertThat(mesh.vertices()).startsWith(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0);
        assertThat(mesh.maps()).containsExactly(0, 0, 1, 0, 0, 1, 0.5, 0.5, 0, 0);
        assertThat(mesh.normals()).containsExactly(0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0);
    }

    @Test
    void obj_givenNormalsOnSomeCornersOnly_usesNoneAndSaysSo() throws IOException {
        String text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3\n";
        MeshData mesh = read("a.obj", text.getBytes(StandardCharsets.UTF_8)).orElseThrow();

        assertThat(mesh.normals()).isNull();
        assertThat(problems.toString()).endsWith("warning: 1 of 3 corners have no normals, so none are used");
    }

    @Test
    void obj_givenMaterials_notesOnceThatTheyAreNotRead() throws IOException {
        String text = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 2 3\n";
        assertThat(read("a.obj", text.getBytes(StandardCharsets.UTF_8))).isPresent();

        assertThat(problems.sorted()).singleElement().satisfies(note -> {
            assertThat(note.severity()).isEqualTo(Severity.WARNING);
            assertThat(note.message()).isEqualTo("not read: mtllib, usemtl; the scene says what the mesh is made of");
        });
    }

    @Test
    void obj_givenLineContinuedByABackslash_readsItWhole() throws IOException {
        assertThat(mesh("a.obj", "v 0 0 0\nv 1 \\\n0 0\nv 0 1 0\nf 1 2 \\\r\n 3\n")
                        .triangles())
                .containsExactly(0, 1, 2);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "f 1 2 4|:4: a face names vertex 4, but the file has 3 vertices",
                "f 1/1 2/1 3/1|:4: a face names texture coordinate 1, but the file has 0 texture coordinates",
                "f 1 2 0|:4: expected the number of a vertex, from 1 or from -1 down to -3, found '0'",
                "f 1 2 -4|:4: expected the number of a vertex, from 1 or from -1 down to -3, found '-4'",
                "f 1 2 x|:4: expected the number of a vertex, from 1 or from -1 down to -3, found 'x'",
                "f 1 2 99999999999999999999|:4: expected the number of a vertex, from 1 or from -1 down to -3, found '99999999999999999999'",
                "f 1 2|:4: a face has at least 3 corners, found 2",
                "v 0 nan 0|:4: expected x, y, z, a finite number, found 'nan'",
                "v 0 NaN 0|:4: expected x, y, z, a finite number, found 'NaN'",
                "v 0 1e999 0|:4: expected x, y, z, a finite number, found '1e999'",
                "v 0 1,5 0|:4: expected x, y, z, a finite number, found '1,5'",
                "v 0 1|:4: expected x, y, z, a number, found the end of the line",
                "# no face|: holds no triangles"
            })
    void obj_givenFault_namesLineAndValue(String line, String expected) throws IOException {
        assertRefused("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + line + "\n", expected);
    }

    @Test
    void obj_givenTrianglesWithoutArea_keepsAndCountsThem() throws IOException {
        String text = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 4\nf 1 2 3\nf 1 1 2\n";
        MeshData mesh = read("a.obj", text.getBytes(StandardCharsets.UTF_8)).orElseThrow();

        assertThat(mesh.triangleCount()).isEqualTo(3);
        assertThat(problems.toString()).endsWith("warning: 2 of 3 triangles have no area; no light meets them");
    }

    @Test
    void obj_givenRandomMesh_agreesWithAnIndependentReader() throws IOException {
        Random random = new Random(7);
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < 500; i++) {
            text.append(String.format(
                    Locale.ROOT, "v %f %e %s%n", random.nextGaussian(), random.nextDouble(), random.nextFloat()));
            text.append(
                    "vt " + random.nextFloat() + " " + random.nextFloat() + "\nvn 0 " + random.nextFloat() + " 1\n");
        }
        for (int i = 0; i < 1000; i++) {
            text.append('f');
            for (int corner = 0; corner < 3; corner++) {
                text.append(" " + (1 + random.nextInt(500)) + "/" + (1 + random.nextInt(500)) + "/-"
                        + (1 + random.nextInt(500)));
            }
            text.append('\n');
        }
        MeshData mesh =
                read("a.obj", text.toString().getBytes(StandardCharsets.UTF_8)).orElseThrow();
        Obj other = ObjReader.read(new StringReader(text.toString()));

        assertThat(mesh.triangleCount()).isEqualTo(other.getNumFaces());
        Set<List<Integer>> combinations = new HashSet<>();
        for (int face = 0; face < other.getNumFaces(); face++) {
            for (int corner = 0; corner < 3; corner++) {
                int ours = mesh.triangles()[3 * face + corner];
                ObjFace theirs = other.getFace(face);
                combinations.add(List.of(
                        theirs.getVertexIndex(corner), theirs.getTexCoordIndex(corner), theirs.getNormalIndex(corner)));
                assertThat((float) mesh.vertices()[3 * ours])
                        .isEqualTo(other.getVertex(other.getFace(face).getVertexIndex(corner))
                                .getX());
                assertThat((float) mesh.vertices()[3 * ours + 1])
                        .isEqualTo(other.getVertex(other.getFace(face).getVertexIndex(corner))
                                .getY());
                assertThat((float) mesh.maps()[2 * ours + 1])
                        .isEqualTo(other.getTexCoord(other.getFace(face).getTexCoordIndex(corner))
                                .getY());
                assertThat((float) mesh.normals()[3 * ours + 1])
                        .isEqualTo(other.getNormal(other.getFace(face).getNormalIndex(corner))
                                .getY());
            }
        }
        assertThat(mesh.vertexCount()).isEqualTo(combinations.size());
    }

    // PLY

    @Test
    void ply_givenText_readsPositionsAndPolygons() throws IOException {
        String text = String.format(Locale.ROOT, PLY_HEAD, "ascii", 4, 1)
                + "0 0 0 255\n1 0 0 255\n1 1 0.25 255\n\n0 1 0 255\n4 0 1 2 3";
        MeshData mesh = mesh("a.ply", text);

        assertThat(mesh.vertices()).containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0.25, 0, 1, 0);
        assertThat(mesh.triangles()).containsExactly(0, 1, 2, 0, 2, 3);
    }

    private static byte[] binaryPly(ByteOrder order, int index) {
        String format = order == ByteOrder.BIG_ENDIAN ? "binary_big_endian" : "binary_little_endian";
        ByteBuffer body = ByteBuffer.allocate(1000).order(order);
        for (int i = 0; i < 4; i++) {
            body.putFloat(i).putFloat(i * i).putFloat(-0.5f).put((byte) 200);
        }
        body.put((byte) 3).putInt(0).putInt(1).putInt(2);
        body.put((byte) 4).putInt(0).putInt(1).putInt(2).putInt(index);
        byte[] head = String.format(Locale.ROOT, PLY_HEAD, format, 4, 2).getBytes(StandardCharsets.US_ASCII);
        return ByteBuffer.allocate(head.length + body.position())
                .put(head)
                .put(body.flip())
                .array();
    }

    @Test
    void ply_givenBinaryOfEitherByteOrder_readsTheSame() throws IOException {
        MeshData little = read("a.ply", binaryPly(ByteOrder.LITTLE_ENDIAN, 3)).orElseThrow();
        MeshData big = read("b.ply", binaryPly(ByteOrder.BIG_ENDIAN, 3)).orElseThrow();

        assertThat(little.vertices()).containsExactly(0, 0, -0.5, 1, 1, -0.5, 2, 4, -0.5, 3, 9, -0.5);
        assertThat(big.vertices()).containsExactly(little.vertices());
        assertThat(little.triangles()).containsExactly(0, 1, 2, 0, 1, 2, 0, 2, 3);
        assertThat(big.triangles()).containsExactly(little.triangles());
        assertThat(problems.sorted()).isEmpty();
    }

    @Test
    void ply_givenNormalsMapsAndForeignElements_takesWhatItKnows() throws IOException {
        MeshData mesh = mesh("a.ply", """
                ply
                format ascii 1.0
                element material 2
                property list uchar int things
                property int n
                element vertex 3
                property double nz
                property double ny
                property double nx
                property list uchar float weights
                property double z
                property double y
                property double x
                property float s
                property float t
                element face 1
                property uchar flags
                property list uint8 uint32 vertex_index
                end_header
                2 7 8 1
                0 1
                1 0 0 2 9 9 30 20 10 0.25 0.5
                1 0 0 0 31 21 11 0.5 0.75
                1 0 0.5 1 9 32 22 13 0.75 1
                6 3 2 1 0
                """);

        assertThat(mesh.vertices()).containsExactly(10, 20, 30, 11, 21, 31, 13, 22, 32);
        assertThat(mesh.normals()).containsExactly(0, 0, 1, 0, 0, 1, 0.5, 0, 1);
        assertThat(mesh.maps()).containsExactly(0.25, 0.5, 0.5, 0.75, 0.75, 1);
        assertThat(mesh.triangles()).containsExactly(2, 1, 0);
    }

    @Test
    void ply_givenCountsThatTheFileIsTooShortFor_refusesThemBeforeAllocating() throws IOException {
        // 3·10⁹ doubles would be 24 GB.
        assertRefused(
                "a.ply",
                String.format(Locale.ROOT, PLY_HEAD, "binary_little_endian", 1_000_000_000, 1) + "x".repeat(100),
                ":4: announces 1000000000 times 'vertex', of at least 13 bytes each, but only 100 bytes are left");
    }

    @Test
    void ply_givenElementsWithoutProperties_refusesThem() throws IOException {
        assertRefused(
                "a.ply",
                "ply\nformat ascii 1.0\nelement nothing 999999999999\nend_header\n",
                ":3: announces 999999999999 times 'nothing', which has no properties");
    }

    @Test
    void ply_givenListLongerThanTheFile_namesTheByte() throws IOException {
        byte[] bytes = binaryPly(ByteOrder.LITTLE_ENDIAN, 3);
        bytes[bytes.length - 17] = (byte) 255;

        assertRefused(
                "a.ply",
                bytes,
                ": byte " + (bytes.length - 17) + ": expected the length of a list, found 255 with" + " 16 bytes left");
    }

    @Test
    void ply_givenIndexOutOfRange_namesTheFacesByte() throws IOException {
        byte[] bytes = binaryPly(ByteOrder.BIG_ENDIAN, 4);

        assertRefused(
                "a.ply",
                bytes,
                ": byte " + (bytes.length - 17) + ": a face names vertex 4, but the file has 4"
                        + " vertices, numbered from 0");
    }

    @Test
    void ply_givenNaN_namesItsByte() throws IOException {
        byte[] bytes = binaryPly(ByteOrder.LITTLE_ENDIAN, 3);
        int body = bytes.length - (4 * 13 + 13 + 17);
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putFloat(body + 13 + 4, Float.NaN);

        assertRefused("a.ply", bytes, ": byte " + (body + 17) + ": expected a finite number, found NaN");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "0 0 0 1;1 0 0 1;0 1 0 1;3 0 1|:15: expected a value, a number, found the end of the line",
                "0 0 0 1;1 0 0 1;0 1 0 1;3 0 1 2 3|:15: expected the end of the line, found '3'",
                "0 0 0 1;1 0 0 1;0 1 0 1;3 0 1 3|:15: a face names vertex 3, but the file has 3 vertices, numbered from 0",
                "0 0 0 1;1 0 0 1;0 1 0 1;3 0 1 -1|:15: expected the number of a vertex, counted from 0, found -1",
                "0 0 0 1;1 0 0 1;0 1 0 1;3 0 1 1.5|:15: expected the number of a vertex, counted from 0, found 1.5",
                "0 0 0 1;1 0 0 1;0 1 0 1;2 0 1 0|:15: a face has at least 3 corners, found 2",
                "0 0 0 1;1 nan 0 1;0 1 0 1;3 0 1 2|:13: expected a value, a finite number, found 'nan'",
                "0 0 0 1;1 0 0 1;0 1 0 1|:9: announces 1 times 'face', of at least 2 bytes each, but only 1 bytes are left",
                "0 0 0 1;1 0 0;0 1 0 1;3 0 1 2|:13: expected a value, found the end of the line"
            })
    void ply_givenFaultInText_namesTheLine(String body, String expected) throws IOException {
        assertRefused("a.ply", String.format(Locale.ROOT, PLY_HEAD, "ascii", 3, 1) + body.replace(';', '\n'), expected);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "plx|:1: is not a PLY file: it must begin with 'ply'",
                "ply;format ebcdic 1.0|:2: expected the format ascii, binary_little_endian or binary_big_endian, found 'ebcdic'",
                "ply;element vertex many|:2: expected the number of elements, found 'many'",
                "ply;element vertex 1;property half x|:3: expected a type such as float or uchar, found 'half'",
                "ply;format ascii 1.0;element vertex 0;end_header|:3: the element 'vertex' must have the properties x, y and z",
                "ply;element vertex 1|:2: the header ends without 'end_header'",
                "ply;property float x|:2: expected element, property or end_header, found 'property'",
                "ply;end_header|:2: the header has no line 'format'"
            })
    void ply_givenFaultInHeader_namesTheLine(String head, String expected) throws IOException {
        assertRefused("a.ply", head.replace(';', '\n'), expected);
    }

    // STL

    private static byte[] binaryStl(int announced, float... corners) {
        ByteBuffer data = ByteBuffer.allocate(84 + 50 * (corners.length / 9)).order(ByteOrder.LITTLE_ENDIAN);
        data.put("solid although it is binary".getBytes(StandardCharsets.US_ASCII))
                .position(80);
        data.putInt(announced);
        for (int i = 0; i < corners.length; i += 9) {
            data.putFloat(0).putFloat(0).putFloat(1);
            for (int k = 0; k < 9; k++) {
                data.putFloat(corners[i + k]);
            }
            data.putShort((short) 0);
        }
        return data.array();
    }

    @Test
    void stl_givenBinary_weldsEqualVertices() throws IOException {
        byte[] bytes = binaryStl(2, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, -0.0f, 1, 1, 0, 0, 1, 0);
        MeshData mesh = read("a.stl", bytes).orElseThrow();

        assertThat(mesh.vertices()).containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0);
        assertThat(mesh.triangles()).containsExactly(0, 1, 2, 1, 3, 2);
        assertThat(problems.sorted()).isEmpty();
    }

    private static final String FACET = """
            facet normal 0 0 1
              outer loop
                vertex 0 0 0
                vertex 1 0 0
                vertex 0 1e0 0
              endloop
            endfacet
            """;

    @Test
    void stl_givenText_readsEverySolid() throws IOException {
        MeshData mesh =
                mesh("a.stl", "solid one part\n" + FACET + FACET + "endsolid one part\nsolid\n" + FACET + "endsolid");

        assertThat(mesh.vertices()).containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0);
        assertThat(mesh.triangles()).containsExactly(0, 1, 2, 0, 1, 2, 0, 1, 2);
    }

    @Test
    void stl_givenTextWithoutEnd_saysWhatIsMissing() throws IOException {
        assertRefused("a.stl", "solid a\n" + FACET, ":9: the file ends where facet or endsolid should follow");
    }

    @Test
    void stl_givenBrokenVertex_namesItsLine() throws IOException {
        assertRefused(
                "a.stl",
                "solid a\n" + FACET.replace("1e0", "inf") + "endsolid a\n",
                ":6: expected y, a finite number, found 'inf'");
    }

    @Test
    void stl_givenFourCorners_namesTheLine() throws IOException {
        assertRefused(
                "a.stl",
                "solid a\n" + FACET.replace("  endloop", "vertex 1 1 0\n  endloop"),
                ":7: expected endloop, found 'vertex'");
    }

    @Test
    void stl_givenWrongCount_saysBothLengths() throws IOException {
        byte[] bytes = binaryStl(2, 0, 0, 0, 1, 0, 0, 0, 1, 0);

        assertRefused("a.stl", bytes, ": byte 80: announces 2 triangles, which make 184 bytes, but the file has 134");
    }

    @Test
    void stl_givenCountOfBillions_allocatesNothingForIt() throws IOException {
        byte[] bytes = binaryStl(-1, 0, 0, 0, 1, 0, 0, 0, 1, 0);

        assertRefused(
                "a.stl",
                bytes,
                ": byte 80: announces 4294967295 triangles, which make 214748364834 bytes, but the file has 134");
    }

    @Test
    void stl_givenNaN_namesItsByte() throws IOException {
        byte[] bytes = binaryStl(1, 0, 0, 0, 1, Float.NaN, 0, 0, 1, 0);

        // 84 bytes of header, 12 of normal, 12 of the first corner, 4 of the second's x.
        assertRefused("a.stl", bytes, ": byte 112: expected a finite number, found NaN");
    }

    // Any format

    @Test
    void read_givenNoFile_isAFileProblem() {
        Path file = folder.resolve("none.obj");

        assertThat(MeshFile.read(file, problems)).isEmpty();
        assertThat(problems).hasToString(file + ": no such file: " + file);
        assertThat(problems.exitCode()).isEqualTo(3);
    }

    @Test
    void read_givenUnknownEnding_namesTheOnesItKnows() throws IOException {
        assertRefused("a.fbx", "x", ": expected a mesh file that ends in .obj, .ply or .stl");
    }

    @ParameterizedTest
    @ValueSource(strings = {"a.obj", "a.ply", "a.stl"})
    void read_givenEmptyFile_refusesIt(String name) throws IOException {
        assertThat(read(name, new byte[0])).isEmpty();
        assertThat(problems.exitCode()).isEqualTo(2);
    }

    @Test
    void read_givenFileBeyondTheLimit_refusesItByItsSize() throws IOException {
        Path file = folder.resolve("huge.stl");
        try (RandomAccessFile sparse = new RandomAccessFile(file.toFile(), "rw")) {
            sparse.setLength(8L << 30);
        }

        assertThat(MeshFile.read(file, problems)).isEmpty();
        assertThat(problems.exitCode()).isEqualTo(4);
        assertThat(problems.toString()).contains("is larger than the limit of");
    }

    @Test
    void read_givenDamagedFiles_alwaysGivesAMeshOrAProblem() throws IOException {
        Random random = new Random(11);
        String ply = String.format(Locale.ROOT, PLY_HEAD, "ascii", 3, 1) + "0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n";
        String obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/-1 4/1/1\n";
        byte[][] seeds = {
            obj.getBytes(StandardCharsets.UTF_8),
            ply.getBytes(StandardCharsets.UTF_8),
            binaryPly(ByteOrder.LITTLE_ENDIAN, 3),
            binaryStl(1, 0, 0, 0, 1, 0, 0, 0, 1, 0),
            ("solid a\n" + FACET + "endsolid a\n").getBytes(StandardCharsets.UTF_8)
        };
        String[] names = {"f.obj", "f.ply", "f.ply", "f.stl", "f.stl"};
        int read = 0;
        for (int trial = 0; trial < 5000; trial++) {
            int kind = trial % seeds.length;
            ByteArrayOutputStream damaged = new ByteArrayOutputStream();
            damaged.write(
                    seeds[kind], 0, random.nextInt(4) == 0 ? random.nextInt(seeds[kind].length) : seeds[kind].length);
            byte[] bytes = damaged.toByteArray();
            for (int i = random.nextInt(4); i > 0 && bytes.length > 0; i--) {
                bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
            }
            Problems found = new Problems();
            Files.write(folder.resolve(names[kind]), bytes);
            boolean present = MeshFile.read(folder.resolve(names[kind]), found).isPresent();
            assertThat(present).isNotEqualTo(found.hasErrors());
            read += present ? 1 : 0;
        }
        assertThat(read).isBetween(500, 4500);
    }
}
