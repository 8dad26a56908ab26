package org.diacaustic.fault;

import java.math.BigDecimal;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Reads JSON after the letter of [RFC 8259], so that what passes here passes everywhere: no NaN, no comma too many, no name
 * twice. Gives all values that are not objects or lists by their paths, such as {@code /seconds/render} and
 * {@code /rounds/0/passes}: texts, {@link BigDecimal}s, {@link Boolean}s and nulls.
 */
final class StrictJson {
    private final String text;
    private final Map<String, Object> values = new LinkedHashMap<>();
    private int at;

    private StrictJson(String text) {
        this.text = text;
    }

    /** @throws IllegalArgumentException if it is not JSON */
    static Map<String, Object> values(String text) {
        StrictJson json = new StrictJson(text);
        json.value("");
        json.space();
        json.require(json.at == text.length(), "the end");
        return json.values;
    }

    private void value(String path) {
        space();
        char first = peek();
        if (first == '{') {
            object(path);
        } else if (first == '[') {
            list(path);
        } else {
            Object value = first == '"' ? string() : word();
            require(!values.containsKey(path), "another name than " + path + " again");
            values.put(path, value);
        }
    }

    private void object(String path) {
        at++;
        space();
        for (boolean first = true; peek() != '}'; first = false) {
            separate(first);
            require(peek() == '"', "a name");
            String name = string();
            space();
            require(next() == ':', "a colon");
            value(path + "/" + name);
            space();
        }
        at++;
    }

    private void list(String path) {
        at++;
        space();
        for (int i = 0; peek() != ']'; i++) {
            separate(i == 0);
            value(path + "/" + i);
            space();
        }
        at++;
    }

    private void separate(boolean first) {
        if (!first) {
            require(next() == ',', "a comma");
            space();
        }
    }

    private String string() {
        StringBuilder string = new StringBuilder();
        at++;
        while (peek() != '"') {
            char c = next();
            require(c >= ' ', "no control character");
            if (c == '\\') {
                char escaped = next();
                require("\"\\/bfnrtu".indexOf(escaped) >= 0, "an escape");
                if (escaped == 'u') {
                    c = (char) Integer.parseInt(text.substring(at, at + 4), 16);
                    at += 4;
                } else {
                    int control = "bfnrt".indexOf(escaped);
                    c = control < 0 ? escaped : "\b\f\n\r\t".charAt(control);
                }
            }
            string.append(c);
        }
        at++;
        return string.toString();
    }

    private Object word() {
        int from = at;
        while (at < text.length() && ",]} \n\r\t".indexOf(text.charAt(at)) < 0) {
            at++;
        }
        String word = text.substring(from, at);
        if (word.equals("null")) {
            return null;
        }
        if (word.equals("true") || word.equals("false")) {
            return word.equals("true");
        }
        require(word.matches("-?(0|[1-9]\\d*)(\\.\\d+)?([eE][-+]?\\d+)?"), "a number instead of " + word);
        return new BigDecimal(word);
    }

    private void space() {
        while (at < text.length() && " \n\r\t".indexOf(text.charAt(at)) >= 0) {
            at++;
        }
    }

    private char peek() {
        require(at < text.length(), "more");
        return text.charAt(at);
    }

    private char next() {
        char c = peek();
        at++;
        return c;
    }

    private void require(boolean met, String what) {
        if (!met) {
            throw new IllegalArgumentException("JSON: " + what + " was expected at character " + at);
        }
    }
}
