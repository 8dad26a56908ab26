package org.diacaustic.scenefile;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.diacaustic.scenefile.Node.Entry;
import org.diacaustic.scenefile.Node.Mapping;
import org.diacaustic.scenefile.Node.Scalar;

/**
 * A YAML 1.2 document (JSON is a subset) with the place of every value. Start at {@link #root}. One that was refused
 * has its reasons in the {@link Problems}, and a root that answers every question with a default and adds no more.
 */
public final class SceneDocument {
    private final FileScope files;
    private final Problems problems;
    private Mapping root;

    private SceneDocument(Mapping root, FileScope files, Problems problems) {
        this.root = root;
        this.files = files;
        this.problems = problems;
    }

    /** Reads a file. What it names must lie in its own folder. */
    public static SceneDocument read(Path file, Problems problems) {
        return read(file, FileScope.inFolderOf(file), problems);
    }

    /** Reads a file that may name files in {@code files}. */
    public static SceneDocument read(Path file, FileScope files, Problems problems) {
        String name = file.toString();
        return TextFile.read(file, problems)
                .map(text -> parse(name, text, files, problems))
                .orElseGet(() -> new SceneDocument(null, files, problems));
    }

    /** Reads a text, which may name no files: it has no folder. */
    public static SceneDocument parse(String name, String text, Problems problems) {
        return parse(name, text, FileScope.NOWHERE, problems);
    }

    public static SceneDocument parse(String name, String text, FileScope files, Problems problems) {
        int before = problems.errorCount();
        Optional<Node> node = YamlParser.parse(name, text, problems);
        if (problems.errorCount() > before) {
            return new SceneDocument(null, files, problems);
        }
        if (node.isEmpty() || node.get() instanceof Scalar scalar && scalar.isNull()) {
            problems.error(new Place(name, 1, 1), "", "holds no scene: the document is empty");
        } else if (!(node.get() instanceof Mapping)) {
            problems.error(
                    node.get().place(),
                    "",
                    "expected a mapping of keys to values, found " + node.get().describe());
        }
        return new SceneDocument(
                node.filter(Mapping.class::isInstance).map(Mapping.class::cast).orElse(null), files, problems);
    }

    /**
     * Lays one value over the document, as {@code -D key=value} does. Problems with it are placed at {@code -D key}.
     *
     * @param under the path of the mapping that it goes into, with dots, such as {@code settings}; empty for the root
     * @param key in that mapping; dots lead deeper; what is not there is made
     * @param value a YAML value in one line: a number, text, {@code [1, 2]}, {@code {a: 1}}
     */
    public void override(String under, String key, String value) {
        if (root == null) {
            return;
        }
        String source = "-D " + key;
        List<String> path = new ArrayList<>(under.isEmpty() ? List.of() : List.of(under.split("\\.", -1)));
        path.addAll(List.of(key.split("\\.", -1)));
        if (path.contains("") || path.size() > YamlParser.MAX_DEPTH) {
            problems.error(Place.of(source), "", "expected a key such as seed or adaptive.depth");
            return;
        }
        int before = problems.errorCount();
        Optional<Node> parsed = YamlParser.parse(source, value, problems);
        if (problems.errorCount() == before) {
            Node node = parsed.orElse(new Scalar(Place.of(source), "", true));
            overlay(root, path, 0, placed(node, Place.of(source))).ifPresent(changed -> root = changed);
        }
    }

    /** The mapping with a value under the keys of {@code path} from {@code depth} on. */
    private Optional<Mapping> overlay(Mapping mapping, List<String> path, int depth, Node value) {
        String key = path.get(depth);
        if (depth == path.size() - 1) {
            return Optional.of(mapping.with(key, value));
        }
        Node next = mapping.entries().stream()
                .filter(entry -> entry.key().text().equals(key))
                .map(Entry::value)
                .findFirst()
                .orElse(new Mapping(value.place(), List.of()));
        if (next instanceof Scalar scalar && scalar.isNull()) {
            next = new Mapping(next.place(), List.of());
        }
        if (!(next instanceof Mapping deeper)) {
            String keys = String.join(".", path.subList(0, depth + 1));
            problems.error(value.place(), keys, "is not a mapping that a value can be put into: " + next.describe());
            return Optional.empty();
        }
        return overlay(deeper, path, depth + 1, value).map(changed -> mapping.with(key, changed));
    }

    /** The same value with every place replaced: inside an option, line and column say nothing. */
    private static Node placed(Node node, Place place) {
        if (node instanceof Scalar scalar) {
            return new Scalar(place, scalar.text(), scalar.plain());
        }
        if (node instanceof Node.Sequence sequence) {
            return new Node.Sequence(
                    place,
                    sequence.items().stream().map(item -> placed(item, place)).toList());
        }
        return new Mapping(
                place,
                ((Mapping) node)
                        .entries().stream()
                                .map(entry ->
                                        new Entry((Scalar) placed(entry.key(), place), placed(entry.value(), place)))
                                .toList());
    }

    /** The keys of the whole document. */
    MappingReader root() {
        return new MappingReader(Section.ofDocument(problems, files), "", root);
    }
}
