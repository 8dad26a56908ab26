package org.diacaustic.scenefile;

import java.util.Set;
import java.util.TreeSet;
import org.diacaustic.shape.MeshData;

/**
 * Reads Wavefront OBJ: {@code v}, {@code vt}, {@code vn} and {@code f} with polygons of any size and negative indices.
 * Our own reader, because a general one keeps coordinates as floats and does not know the line of a wrong index.
 */
final class ObjMesh {
    /** Stands for a corner's normal or map index that is not given. */
    private static final int NONE = -1;

    private static final Set<String> NAMES_AND_GROUPS = Set.of("o", "g", "s", "vp", "l", "p", "mg", "cstype");

    private final MeshText text;
    private final MeshAssembly assembly;
    private final DoubleList vertices = new DoubleList();
    private final DoubleList maps = new DoubleList();
    private final DoubleList normals = new DoubleList();
    private final Polygons faces = new Polygons();
    private final IntList mapOfCorner = new IntList();
    private final IntList normalOfCorner = new IntList();
    private final Set<String> ignored = new TreeSet<>();

    ObjMesh(byte[] bytes, MeshAssembly assembly) {
        text = new MeshText(bytes);
        this.assembly = assembly;
    }

    MeshData read() {
        do {
            if (text.nextWord()) {
                readLine();
            }
        } while (text.nextLine());
        if (!ignored.isEmpty()) {
            assembly.warn("not read: " + String.join(", ", ignored) + "; the scene says what the mesh is made of");
        }
        checkIndices();
        boolean hasMaps = isOnEveryCorner(mapOfCorner, "texture coordinates");
        boolean hasNormals = isOnEveryCorner(normalOfCorner, "normals");
        return hasMaps || hasNormals ? unified(hasMaps, hasNormals) : plain();
    }

    private void readLine() {
        if (text.is("v")) {
            addNumbers(vertices, 3, "x, y, z");
        } else if (text.is("vn")) {
            addNumbers(normals, 3, "a normal's x, y, z");
        } else if (text.is("vt")) {
            maps.add(text.number("u"));
            maps.add(optionalNumber());
        } else if (text.is("f")) {
            readFace();
        } else if (text.at(0) != '#' && !NAMES_AND_GROUPS.contains(text.word())) {
            ignore(text.word());
        }
    }

    private void addNumbers(DoubleList list, int count, String what) {
        for (int i = 0; i < count; i++) {
            list.add(text.number(what));
        }
    }

    private double optionalNumber() {
        return text.nextWord() ? text.numberHere("v") : 0;
    }

    private void ignore(String keyword) {
        // Enough to tell; a file of other content has as many keywords as lines.
        if (ignored.size() < 8) {
            ignored.add(Problem.printable(keyword, 20));
        }
    }

    private void readFace() {
        int line = text.line();
        int corners = 0;
        while (text.nextWord() && text.at(0) != '#') {
            readCorner();
            corners++;
        }
        if (corners < 3) {
            throw MeshFault.atLine(line, "a face has at least 3 corners, found " + corners);
        }
        faces.endFace(line);
    }

    /** One of {@code 1}, {@code 1/2}, {@code 1//3}, {@code 1/2/3}: position, texture coordinates, normal. */
    private void readCorner() {
        int firstSlash = slash(0);
        int secondSlash = slash(firstSlash + 1);
        faces.addCorner(index(0, firstSlash, vertices.size() / 3, "vertex"));
        boolean hasMap = firstSlash + 1 < secondSlash;
        mapOfCorner.add(hasMap ? index(firstSlash + 1, secondSlash, maps.size() / 2, "texture coordinate") : NONE);
        boolean hasNormal = secondSlash < text.length();
        normalOfCorner.add(hasNormal ? index(secondSlash + 1, text.length(), normals.size() / 3, "normal") : NONE);
    }

    /** Where the next slash of the current word is, or the word's end. */
    private int slash(int from) {
        int i = from;
        while (i < text.length() && text.at(i) != '/') {
            i++;
        }
        return Math.min(i, text.length());
    }

    /** An index from 0 of one that counts from 1, or back from the latest if it is negative. */
    private int index(int begin, int end, int known, String what) {
        boolean negative = begin < end && text.at(begin) == '-';
        long value = 0;
        for (int i = negative ? begin + 1 : begin; i < end && value <= Integer.MAX_VALUE; i++) {
            byte digit = text.at(i);
            value = digit >= '0' && digit <= '9' ? 10 * value + (digit - '0') : Long.MAX_VALUE;
        }
        if (value == 0 || value > Integer.MAX_VALUE || negative && value > known) {
            throw text.fault("expected the number of a " + what + ", from 1 or from -1 down to " + -known + ", found '"
                    + Problem.printable(text.word(), 40) + "'");
        }
        return negative ? known - (int) value : (int) value - 1;
    }

    /** Positive indices may name what follows, so they are checked when all is known. */
    private void checkIndices() {
        for (int face = 0; face < faces.count(); face++) {
            for (int c = faces.begin(face); c < faces.end(face); c++) {
                check(face, faces.corner(c), vertices.size() / 3, "vertex", "vertices");
                check(face, mapOfCorner.get(c), maps.size() / 2, "texture coordinate", "texture coordinates");
                check(face, normalOfCorner.get(c), normals.size() / 3, "normal", "normals");
            }
        }
    }

    private void check(int face, int index, int count, String one, String many) {
        if (index >= count) {
            String message = "a face names " + one + " " + (index + 1) + ", but the file has " + count + " " + many;
            throw MeshFault.atLine(faces.location(face), message);
        }
    }

    /** Whether every corner has one; a warning if only some do. */
    private boolean isOnEveryCorner(IntList indices, String what) {
        int without = 0;
        for (int c = 0; c < indices.size(); c++) {
            without += indices.get(c) == NONE ? 1 : 0;
        }
        if (without > 0 && without < indices.size()) {
            assembly.warn(without + " of " + indices.size() + " corners have no " + what + ", so none are used");
        }
        return without == 0 && indices.size() > 0;
    }

    private MeshData plain() {
        double[] points = vertices.toArray();
        return assembly.finish(points, assembly.triangulate(faces, points, this::tooManyCorners), null, null);
    }

    /** Makes one vertex of each combination of position, texture coordinates and normal that a corner has. */
    private MeshData unified(boolean hasMaps, boolean hasNormals) {
        TripleIndex combinations = new TripleIndex();
        Polygons renumbered = new Polygons();
        for (int face = 0; face < faces.count(); face++) {
            for (int c = faces.begin(face); c < faces.end(face); c++) {
                renumbered.addCorner(combinations.indexOf(
                        faces.corner(c),
                        hasMaps ? mapOfCorner.get(c) : NONE,
                        hasNormals ? normalOfCorner.get(c) : NONE));
            }
            renumbered.endFace(faces.location(face));
        }
        double[] points = select(vertices, 3, combinations, 0);
        int[] triangles = assembly.triangulate(renumbered, points, this::tooManyCorners);
        return assembly.finish(
                points,
                triangles,
                hasNormals ? select(normals, 3, combinations, 2) : null,
                hasMaps ? select(maps, 2, combinations, 1) : null);
    }

    private static double[] select(DoubleList values, int each, TripleIndex combinations, int part) {
        double[] selected = new double[Math.multiplyExact(each, combinations.size())];
        for (int i = 0; i < selected.length; i++) {
            selected[i] = values.get(each * (int) combinations.key(i / each, part) + i % each);
        }
        return selected;
    }

    private MeshFault tooManyCorners(int face) {
        return MeshFault.atLine(faces.location(face), PolygonCutter.TOO_MANY_CORNERS);
    }
}
