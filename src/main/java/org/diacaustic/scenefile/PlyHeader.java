package org.diacaustic.scenefile;

import java.util.ArrayList;
import java.util.List;

/**
 * What a PLY file says that it holds.
 *
 * @param bodyOffset of the first byte after the header
 */
record PlyHeader(Format format, List<Element> elements, int bodyOffset) {

    enum Format {
        ASCII,
        BINARY_LITTLE_ENDIAN,
        BINARY_BIG_ENDIAN
    }

    /** @param countType of a list's length; null for a single number */
    record Property(String name, PlyType type, PlyType countType) {
        boolean isList() {
            return countType != null;
        }
    }

    /** @param line of the header, for messages */
    record Element(String name, long count, int line, List<Property> properties) {

        /** The fewest bytes that one can take: in text, a digit and a separator for each number. */
        long fewestBytes(Format format) {
            long bytes = 0;
            for (Property property : properties) {
                PlyType first = property.isList() ? property.countType : property.type;
                bytes += format == Format.ASCII ? 2 : first.bytes();
            }
            return bytes;
        }

        /** Which property has a name, or -1. */
        int indexOf(String property) {
            for (int i = 0; i < properties.size(); i++) {
                if (properties.get(i).name.equals(property)) {
                    return i;
                }
            }
            return -1;
        }
    }

    /** Reads the header; {@code text} is left at the start of the body. */
    static PlyHeader read(MeshText text) {
        if (!text.nextWord() || !text.is("ply")) {
            throw text.fault("is not a PLY file: it must begin with 'ply'");
        }
        Format format = null;
        List<Element> elements = new ArrayList<>();
        while (text.nextLine()) {
            if (!text.nextWord() || text.is("comment") || text.is("obj_info")) {
                continue;
            }
            if (text.is("end_header")) {
                if (format == null) {
                    throw text.fault("the header has no line 'format'");
                }
                text.nextLine();
                return new PlyHeader(format, elements, text.position());
            }
            if (text.is("format")) {
                format = format(text);
            } else if (text.is("element")) {
                elements.add(element(text));
            } else if (text.is("property") && !elements.isEmpty()) {
                elements.get(elements.size() - 1).properties.add(property(text));
            } else {
                throw text.fault(
                        "expected element, property or end_header, found '" + Problem.printable(text.word(), 40) + "'");
            }
        }
        throw text.fault("the header ends without 'end_header'");
    }

    private static Format format(MeshText text) {
        String name = word(text, "a format");
        for (Format format : Format.values()) {
            if (format.name().equalsIgnoreCase(name)) {
                return format;
            }
        }
        throw text.fault("expected the format ascii, binary_little_endian or binary_big_endian, found '"
                + Problem.printable(name, 40) + "'");
    }

    private static Element element(MeshText text) {
        String name = word(text, "an element's name");
        String digits = word(text, "the number of elements");
        if (!digits.matches("[0-9]{1,18}")) {
            throw text.fault("expected the number of elements, found '" + Problem.printable(digits, 40) + "'");
        }
        return new Element(name, Long.parseLong(digits), text.line(), new ArrayList<>());
    }

    private static Property property(MeshText text) {
        String first = word(text, "a type");
        if (!first.equals("list")) {
            PlyType type = type(text, first);
            return new Property(word(text, "a property's name"), type, null);
        }
        PlyType countType = type(text, word(text, "a type"));
        PlyType type = type(text, word(text, "a type"));
        if (countType == PlyType.FLOAT32 || countType == PlyType.FLOAT64) {
            throw text.fault("the length of a list must be a whole number, not float or double");
        }
        return new Property(word(text, "a property's name"), type, countType);
    }

    private static PlyType type(MeshText text, String name) {
        PlyType type = PlyType.named(name);
        if (type == null) {
            throw text.fault("expected a type such as float or uchar, found '" + Problem.printable(name, 40) + "'");
        }
        return type;
    }

    private static String word(MeshText text, String what) {
        if (!text.nextWord()) {
            throw text.fault("expected " + what + ", found the end of the line");
        }
        return text.word();
    }
}
