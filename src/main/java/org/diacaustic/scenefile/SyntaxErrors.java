package org.diacaustic.scenefile;

import java.util.Locale;
import java.util.Optional;
import org.diacaustic.scenefile.Problem.Kind;
import org.diacaustic.scenefile.Problem.Severity;
import org.snakeyaml.engine.v2.exceptions.Mark;
import org.snakeyaml.engine.v2.exceptions.MarkedYamlEngineException;
import org.snakeyaml.engine.v2.exceptions.ReaderException;

/** Turns what the YAML parser says about text that is not YAML into one located line. */
final class SyntaxErrors {
    private SyntaxErrors() {}

    static Problem explain(String source, MarkedYamlEngineException syntax) {
        String found = oneLine(syntax.getProblem());
        Optional<Mark> at = syntax.getProblemMark();
        Optional<Mark> began = syntax.getContextMark();
        if (found.startsWith("expected ',' or") && began.isPresent()) {
            // A bracket left open is only noticed later, often lines below; what helps is where it was opened.
            String noticed = at.map(mark -> " at line " + (mark.getLine() + 1) + ", column " + (mark.getColumn() + 1))
                    .orElse("");
            return problem(
                    YamlParser.place(source, began), "the bracket opened here is not closed: " + found + noticed);
        }
        if (found.contains("unexpected end of stream") && began.isPresent()) {
            return problem(YamlParser.place(source, began), "the quote opened here is not closed");
        }
        if (found.contains("TAB")) {
            found = "a tab cannot begin a value or indent it; use spaces";
        }
        return problem(YamlParser.place(source, at.or(() -> began)), "is not YAML: " + found);
    }

    static Problem explain(String source, String text, ReaderException character) {
        int position = Math.min(character.getPosition(), text.length());
        String before = text.substring(
                0, text.offsetByCodePoints(0, Math.min(position, text.codePointCount(0, text.length()))));
        int line = 1 + (int) before.chars().filter(c -> c == '\n').count();
        int column = before.length() - before.lastIndexOf('\n');
        String code = String.format(Locale.ROOT, "U+%04X", character.getCodePoint());
        return problem(new Place(source, line, column), "the character " + code + " is not allowed in YAML");
    }

    private static Problem problem(Place place, String message) {
        return new Problem(Severity.ERROR, Kind.BAD_INPUT, place, "", message);
    }

    private static String oneLine(String text) {
        return text.replaceAll("\\s+", " ").strip();
    }
}
