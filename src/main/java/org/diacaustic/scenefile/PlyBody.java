package org.diacaustic.scenefile;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** The numbers of a PLY file's body one after another, whichever way they are written. */
interface PlyBody {

    /** Called before the numbers of each element. */
    void begin();

    /** Called after them. */
    void end();

    /** The next number, which is finite. */
    double next(PlyType type);

    /** Passes over one number, whatever it is. */
    void skip(PlyType type);

    /** The line or byte at which the current element stands. */
    int location();

    /** How many bytes are left. */
    long remaining();

    MeshFault fault(int location, String message);

    /** One element a line. */
    record Text(MeshText text, int length) implements PlyBody {
        @Override
        public void begin() {
            while (!text.nextWord()) {
                if (!text.nextLine()) {
                    throw text.fault("the file ends before all that its header announces");
                }
            }
            text.back();
        }

        @Override
        public void end() {
            if (text.nextWord()) {
                throw text.fault("expected the end of the line, found '" + Problem.printable(text.word(), 40) + "'");
            }
            text.nextLine();
        }

        @Override
        public double next(PlyType type) {
            return text.number("a value");
        }

        @Override
        public void skip(PlyType type) {
            if (!text.nextWord()) {
                throw text.fault("expected a value, found the end of the line");
            }
        }

        @Override
        public int location() {
            return text.line();
        }

        @Override
        public long remaining() {
            // The last line may lack its end.
            return length - text.position() + 1L;
        }

        @Override
        public MeshFault fault(int location, String message) {
            return MeshFault.atLine(location, message);
        }
    }

    /** Numbers without separators. */
    final class Binary implements PlyBody {
        private final ByteBuffer data;
        private int elementStart;

        Binary(byte[] bytes, int offset, ByteOrder order) {
            data = ByteBuffer.wrap(bytes).position(offset).order(order);
        }

        @Override
        public void begin() {
            elementStart = data.position();
        }

        @Override
        public void end() {}

        @Override
        public double next(PlyType type) {
            if (data.remaining() < type.bytes()) {
                throw endOfFile();
            }
            int at = data.position();
            double value = type.read(data);
            if (!Double.isFinite(value)) {
                throw MeshFault.atByte(at, "expected a finite number, found " + value);
            }
            return value;
        }

        @Override
        public void skip(PlyType type) {
            if (data.remaining() < type.bytes()) {
                throw endOfFile();
            }
            data.position(data.position() + type.bytes());
        }

        private MeshFault endOfFile() {
            return MeshFault.atByte(data.limit(), "the file ends before all that its header announces");
        }

        @Override
        public int location() {
            return elementStart;
        }

        @Override
        public long remaining() {
            return data.remaining();
        }

        @Override
        public MeshFault fault(int location, String message) {
            return MeshFault.atByte(location, message);
        }
    }
}
