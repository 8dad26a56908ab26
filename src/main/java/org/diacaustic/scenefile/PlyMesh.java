package org.diacaustic.scenefile;

import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import org.diacaustic.scenefile.PlyHeader.Element;
import org.diacaustic.scenefile.PlyHeader.Property;
import org.diacaustic.shape.MeshData;

/**
 * Reads PLY, text and binary of both byte orders: positions, normals, texture coordinates and polygons of any size.
 * Other properties and elements are passed over.
 */
final class PlyMesh {
    private static final String[] POSITION = {"x", "y", "z"};
    private static final String[] NORMAL = {"nx", "ny", "nz"};
    private static final List<String[]> MAPS =
            List.of(new String[] {"u", "v"}, new String[] {"s", "t"}, new String[] {"texture_u", "texture_v"});

    private final PlyHeader header;
    private final PlyBody body;
    private final MeshAssembly assembly;
    private double[] vertices = new double[0];
    private double[] normals;
    private double[] maps;
    private final Polygons faces = new Polygons();

    PlyMesh(byte[] bytes, MeshAssembly assembly) {
        this.assembly = assembly;
        MeshText text = new MeshText(bytes);
        header = PlyHeader.read(text);
        body = switch (header.format()) {
            case ASCII -> new PlyBody.Text(text, bytes.length);
            case BINARY_LITTLE_ENDIAN -> new PlyBody.Binary(bytes, header.bodyOffset(), ByteOrder.LITTLE_ENDIAN);
            case BINARY_BIG_ENDIAN -> new PlyBody.Binary(bytes, header.bodyOffset(), ByteOrder.BIG_ENDIAN);
        };
    }

    MeshData read() {
        for (Element element : header.elements()) {
            requireRoom(element);
            switch (element.name()) {
                case "vertex" -> readVertices(element);
                case "face" -> readFaces(element);
                case "tristrips" ->
                    throw MeshFault.atLine(element.line(), "triangle strips are not read; save the mesh with faces");
                default -> skip(element);
            }
        }
        checkIndices();
        int[] triangles = assembly.triangulate(
                faces, vertices, face -> body.fault(faces.location(face), PolygonCutter.TOO_MANY_CORNERS));
        return assembly.finish(vertices, triangles, normals, maps);
    }

    /** Refuses a count that the file is too short for, before anything of that size is made. */
    private void requireRoom(Element element) {
        long each = element.fewestBytes(header.format());
        boolean empty = each == 0 && element.count() > 0;
        if (empty || each > 0 && element.count() > body.remaining() / each) {
            String message = "announces " + element.count() + " times '" + Problem.printable(element.name(), 40) + "'"
                    + (empty
                            ? ", which has no properties"
                            : ", of at least " + each + " bytes each, but only " + body.remaining()
                                    + " bytes are left");
            throw MeshFault.atLine(element.line(), message);
        }
    }

    private void readVertices(Element element) {
        int count = (int) element.count();
        int[] target = new int[element.properties().size()];
        Arrays.fill(target, -1);
        if (!claim(element, POSITION, target, 0)) {
            throw MeshFault.atLine(element.line(), "the element 'vertex' must have the properties x, y and z");
        }
        vertices = new double[Math.multiplyExact(3, count)];
        normals = claim(element, NORMAL, target, 3) ? new double[3 * count] : null;
        boolean hasMaps = MAPS.stream().anyMatch(names -> claim(element, names, target, 6));
        maps = hasMaps ? new double[2 * count] : null;
        double[] row = new double[8];
        for (int i = 0; i < count; i++) {
            body.begin();
            for (int p = 0; p < target.length; p++) {
                Property property = element.properties().get(p);
                if (property.isList() || target[p] < 0) {
                    skip(property);
                } else {
                    row[target[p]] = body.next(property.type());
                }
            }
            body.end();
            System.arraycopy(row, 0, vertices, 3 * i, 3);
            if (normals != null) {
                System.arraycopy(row, 3, normals, 3 * i, 3);
            }
            if (maps != null) {
                System.arraycopy(row, 6, maps, 2 * i, 2);
            }
        }
    }

    /** Notes for each named property where in a row it goes; false, and nothing noted, unless all are there. */
    private static boolean claim(Element element, String[] names, int[] target, int first) {
        for (String name : names) {
            int index = element.indexOf(name);
            if (index < 0 || element.properties().get(index).isList()) {
                return false;
            }
        }
        for (int i = 0; i < names.length; i++) {
            target[element.indexOf(names[i])] = first + i;
        }
        return true;
    }

    private void readFaces(Element element) {
        int indices = Math.max(element.indexOf("vertex_indices"), element.indexOf("vertex_index"));
        if (indices < 0 || !element.properties().get(indices).isList()) {
            throw MeshFault.atLine(element.line(), "the element 'face' must have the list vertex_indices");
        }
        for (long i = 0; i < element.count(); i++) {
            body.begin();
            for (int p = 0; p < element.properties().size(); p++) {
                Property property = element.properties().get(p);
                if (p == indices) {
                    readFace(property);
                } else {
                    skip(property);
                }
            }
            body.end();
        }
    }

    private void readFace(Property list) {
        int corners = length(list);
        if (corners < 3) {
            throw body.fault(body.location(), "a face has at least 3 corners, found " + corners);
        }
        for (int i = 0; i < corners; i++) {
            double index = body.next(list.type());
            if (!(index >= 0 && index <= Integer.MAX_VALUE && index == Math.rint(index))) {
                throw body.fault(
                        body.location(), "expected the number of a vertex, counted from 0, found " + shown(index));
            }
            faces.addCorner((int) index);
        }
        faces.endFace(body.location());
    }

    private int length(Property list) {
        double length = body.next(list.countType());
        if (!(length >= 0 && length <= body.remaining() && length == Math.rint(length))) {
            throw body.fault(
                    body.location(),
                    "expected the length of a list, found " + shown(length) + " with " + body.remaining()
                            + " bytes left");
        }
        return (int) length;
    }

    /** A whole number without a point. */
    private static String shown(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15
                ? Long.toString((long) value)
                : Double.toString(value);
    }

    private void skip(Element element) {
        for (long i = 0; i < element.count(); i++) {
            body.begin();
            element.properties().forEach(this::skip);
            body.end();
        }
    }

    private void skip(Property property) {
        int count = property.isList() ? length(property) : 1;
        for (int i = 0; i < count; i++) {
            body.skip(property.type());
        }
    }

    /** Faces may stand before the vertices that they name, so this is checked when all is known. */
    private void checkIndices() {
        int count = vertices.length / 3;
        for (int face = 0; face < faces.count(); face++) {
            for (int c = faces.begin(face); c < faces.end(face); c++) {
                if (faces.corner(c) >= count) {
                    String message = "a face names vertex " + faces.corner(c) + ", but the file has " + count
                            + " vertices, numbered from 0";
                    throw body.fault(faces.location(face), message);
                }
            }
        }
    }
}
