package org.diacaustic.json;

import java.util.ArrayDeque;
import java.util.Deque;

/**
 * Writes JSON [RFC 8259] in indented lines, the same in every locale. NaN and infinities, which JSON has no numbers
 * for, become {@code null}; longs keep every digit.
 *
 * <pre>{@code
 * new JsonWriter().beginObject().put("seed", 7).name("size").beginArray().value(200).value(100).end().end()
 * }</pre>
 *
 * Calls that would not make JSON throw {@link IllegalStateException}.
 */
public final class JsonWriter {
    private static final String HEX = "0123456789abcdef";

    private final StringBuilder out = new StringBuilder();
    private final Deque<Level> levels = new ArrayDeque<>();
    private boolean named;

    /** An object or array that is open. */
    private static final class Level {
        private final boolean object;
        private boolean empty = true;

        Level(boolean object) {
            this.object = object;
        }
    }

    public JsonWriter beginObject() {
        return begin(true);
    }

    public JsonWriter beginArray() {
        return begin(false);
    }

    private JsonWriter begin(boolean object) {
        beforeValue();
        out.append(object ? '{' : '[');
        levels.push(new Level(object));
        return this;
    }

    /** Ends the object or array begun last. */
    public JsonWriter end() {
        require(!levels.isEmpty() && !named, "nothing to end here");
        Level level = levels.pop();
        if (!level.empty) {
            newLine();
        }
        out.append(level.object ? '}' : ']');
        return this;
    }

    /** The name of the next value of an object. */
    public JsonWriter name(String name) {
        require(!levels.isEmpty() && levels.peek().object && !named, "a name belongs before a value of an object");
        separate();
        quote(name);
        out.append(": ");
        named = true;
        return this;
    }

    /** Text, or {@code null}. */
    public JsonWriter value(String text) {
        beforeValue();
        if (text == null) {
            out.append("null");
        } else {
            quote(text);
        }
        return this;
    }

    /** The shortest decimal that reads back as the same double. */
    public JsonWriter value(double number) {
        beforeValue();
        out.append(Double.isFinite(number) ? Double.toString(number) : "null");
        return this;
    }

    public JsonWriter value(long number) {
        beforeValue();
        out.append(number);
        return this;
    }

    public JsonWriter value(boolean flag) {
        beforeValue();
        out.append(flag);
        return this;
    }

    public JsonWriter put(String name, String text) {
        return name(name).value(text);
    }

    public JsonWriter put(String name, double number) {
        return name(name).value(number);
    }

    public JsonWriter put(String name, long number) {
        return name(name).value(number);
    }

    public JsonWriter put(String name, boolean flag) {
        return name(name).value(flag);
    }

    private void beforeValue() {
        if (levels.isEmpty()) {
            require(out.length() == 0, "one document holds one value");
        } else if (levels.peek().object) {
            require(named, "a value of an object needs a name");
            named = false;
        } else {
            separate();
        }
    }

    private void separate() {
        if (!levels.peek().empty) {
            out.append(',');
        }
        levels.peek().empty = false;
        newLine();
    }

    private void newLine() {
        out.append('\n').append("  ".repeat(levels.size()));
    }

    private void quote(String text) {
        out.append('"');
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            switch (c) {
                case '"', '\\' -> out.append('\\').append(c);
                case '\n' -> out.append("\\n");
                case '\t' -> out.append("\\t");
                case '\r' -> out.append("\\r");
                default -> {
                    if (c < ' ' || isLoneSurrogate(text, i)) {
                        out.append("\\u").append(HEX.charAt(c >> 12)).append(HEX.charAt(c >> 8 & 15));
                        out.append(HEX.charAt(c >> 4 & 15)).append(HEX.charAt(c & 15));
                    } else {
                        out.append(c);
                    }
                }
            }
        }
        out.append('"');
    }

    /** Half a character, as broken file names have, cannot be written in UTF-8. */
    private static boolean isLoneSurrogate(String text, int i) {
        char c = text.charAt(i);
        boolean paired = Character.isHighSurrogate(c)
                ? i + 1 < text.length() && Character.isLowSurrogate(text.charAt(i + 1))
                : i > 0 && Character.isHighSurrogate(text.charAt(i - 1));
        return Character.isSurrogate(c) && !paired;
    }

    private static void require(boolean condition, String message) {
        if (!condition) {
            throw new IllegalStateException(message);
        }
    }

    /**
     * The document.
     *
     * @throws IllegalStateException if it is not complete
     */
    @Override
    public String toString() {
        require(levels.isEmpty() && out.length() > 0, "the document is not complete");
        return out + "\n";
    }
}
