package org.diacaustic.scenefile;

import java.nio.ByteBuffer;

/** The numbers of a PLY file, each with its two names. A double holds every one of them exactly. */
enum PlyType {
    INT8("char", "int8", 1),
    UINT8("uchar", "uint8", 1),
    INT16("short", "int16", 2),
    UINT16("ushort", "uint16", 2),
    INT32("int", "int32", 4),
    UINT32("uint", "uint32", 4),
    FLOAT32("float", "float32", 4),
    FLOAT64("double", "float64", 8);

    private final String oldName;
    private final String newName;
    private final int bytes;

    PlyType(String oldName, String newName, int bytes) {
        this.oldName = oldName;
        this.newName = newName;
        this.bytes = bytes;
    }

    /** The type of a name, or null. */
    static PlyType named(String name) {
        for (PlyType type : values()) {
            if (name.equals(type.oldName) || name.equals(type.newName)) {
                return type;
            }
        }
        return null;
    }

    int bytes() {
        return bytes;
    }

    double read(ByteBuffer data) {
        return switch (this) {
            case INT8 -> data.get();
            case UINT8 -> data.get() & 0xFF;
            case INT16 -> data.getShort();
            case UINT16 -> data.getShort() & 0xFFFF;
            case INT32 -> data.getInt();
            case UINT32 -> data.getInt() & 0xFFFFFFFFL;
            case FLOAT32 -> data.getFloat();
            case FLOAT64 -> data.getDouble();
        };
    }
}
