package org.diacaustic.scenefile;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.diacaustic.scenefile.Node.Entry;
import org.diacaustic.scenefile.Node.Mapping;
import org.diacaustic.scenefile.Node.Scalar;
import org.diacaustic.scenefile.Node.Sequence;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.common.Anchor;
import org.snakeyaml.engine.v2.events.AliasEvent;
import org.snakeyaml.engine.v2.events.CollectionStartEvent;
import org.snakeyaml.engine.v2.events.Event;
import org.snakeyaml.engine.v2.events.NodeEvent;
import org.snakeyaml.engine.v2.events.ScalarEvent;
import org.snakeyaml.engine.v2.exceptions.Mark;
import org.snakeyaml.engine.v2.exceptions.MarkedYamlEngineException;
import org.snakeyaml.engine.v2.exceptions.ReaderException;
import org.snakeyaml.engine.v2.exceptions.YamlEngineException;
import org.snakeyaml.engine.v2.exceptions.YamlVersionException;
import org.snakeyaml.engine.v2.parser.ParserImpl;
import org.snakeyaml.engine.v2.scanner.StreamReader;

/**
 * Builds nodes from parse events, with every limit checked before anything of that size exists: the event stream is
 * flat, so neither nesting nor aliases can exhaust stack or heap. Tags are refused, so nothing in a text names a type.
 */
final class YamlParser {
    static final int MAX_DEPTH = 50;
    /** Values in the document with every alias written out. */
    static final long MAX_VALUES = 500_000;
    /** The reader's window. Small ones make it copy a long line over and over; a large one costs 6 bytes each. */
    private static final int WINDOW = 1 << 20;

    private final String source;
    private final Deque<Open> open = new ArrayDeque<>();
    private final Map<Anchor, Anchored> anchors = new HashMap<>();
    private long values;

    private YamlParser(String source) {
        this.source = source;
    }

    /**
     * The one document of a text; nothing if there is none, or if it was refused and {@code problems} say why.
     *
     * @param source the name for places
     */
    static Optional<Node> parse(String source, String text, Problems problems) {
        try {
            return new YamlParser(source).document(text);
        } catch (Refused refused) {
            problems.error(refused.place, "", refused.getMessage());
        } catch (MarkedYamlEngineException syntax) {
            problems.add(SyntaxErrors.explain(source, syntax));
        } catch (ReaderException character) {
            problems.add(SyntaxErrors.explain(source, text, character));
        } catch (YamlVersionException version) {
            problems.error(new Place(source, 1, 1), "", "is YAML of another version; a scene file is YAML 1.2");
        } catch (YamlEngineException other) {
            problems.error(Place.of(source), "", "is not YAML: " + other.getMessage());
        }
        return Optional.empty();
    }

    private Optional<Node> document(String text) {
        LoadSettings settings = LoadSettings.builder()
                .setLabel(source)
                .setCodePointLimit(Integer.MAX_VALUE)
                .setBufferSize(Math.min(text.length() + 1, WINDOW))
                .build();
        // Not Parse, the usual way to events: the library's module does not export its package.
        Iterator<Event> events = new ParserImpl(settings, new StreamReader(settings, text));
        Node root = null;
        int documents = 0;
        while (events.hasNext()) {
            Event event = events.next();
            switch (event.getEventId()) {
                case DocumentStart -> {
                    if (++documents > 1) {
                        throw new Refused(place(event), "a second document begins here; a scene file holds one");
                    }
                }
                case Scalar, Alias, SequenceStart, MappingStart, SequenceEnd, MappingEnd -> {
                    Node whole = take(event);
                    root = open.isEmpty() ? whole : root;
                }
                default -> {}
            }
        }
        return Optional.ofNullable(root);
    }

    /** Takes in one event and gives the node that it completes, or null. */
    private Node take(Event event) {
        if (event instanceof AliasEvent alias) {
            return addToParent(resolve(alias));
        }
        if (event instanceof ScalarEvent scalar) {
            refuseTag(scalar.getTag(), scalar);
            count(1, place(scalar));
            Node node = new Scalar(place(scalar), scalar.getValue(), scalar.isPlain());
            scalar.getAnchor().ifPresent(anchor -> anchors.put(anchor, new Anchored(node, 1)));
            return addToParent(node);
        }
        if (event instanceof CollectionStartEvent start) {
            refuseTag(start.getTag(), start);
            begin(start);
            return null;
        }
        return addToParent(end());
    }

    private void begin(CollectionStartEvent start) {
        if (open.size() == MAX_DEPTH) {
            throw new Refused(place(start), "nested deeper than the limit of " + MAX_DEPTH + " levels");
        }
        boolean mapping = start.getEventId() == Event.ID.MappingStart;
        open.push(new Open(place(start), mapping, start.getAnchor().orElse(null), values));
        count(1, place(start));
    }

    private Node end() {
        Open done = open.pop();
        Node node = done.toNode();
        if (done.anchor != null) {
            anchors.put(done.anchor, new Anchored(node, values - done.valuesBefore));
        }
        return node;
    }

    private Node addToParent(Node node) {
        if (!open.isEmpty()) {
            open.peek().add(node);
        }
        return node;
    }

    private Node resolve(AliasEvent alias) {
        Anchor name = alias.getAlias();
        if (open.stream().anyMatch(collection -> name.equals(collection.anchor))) {
            throw new Refused(place(alias), "*" + name + " stands inside what it names: " + cycle(name));
        }
        Anchored anchored = anchors.get(name);
        if (anchored == null) {
            throw new Refused(
                    place(alias), "*" + name + " is not defined; write &" + name + " before the value it names");
        }
        count(anchored.size, place(alias));
        return anchored.node;
    }

    /** The anchors from the one named inward and back to it. */
    private String cycle(Anchor name) {
        StringBuilder path = new StringBuilder();
        boolean inside = false;
        for (Iterator<Open> inward = open.descendingIterator(); inward.hasNext(); ) {
            Anchor anchor = inward.next().anchor;
            inside |= name.equals(anchor);
            if (inside && anchor != null) {
                path.append(anchor).append(" -> ");
            }
        }
        return path.append(name).toString();
    }

    private void count(long more, Place place) {
        values += more;
        if (values > MAX_VALUES) {
            throw new Refused(place, "more values than the limit of " + MAX_VALUES + ", counting what aliases repeat");
        }
    }

    private void refuseTag(Optional<String> tag, NodeEvent event) {
        if (tag.isPresent()) {
            throw new Refused(
                    place(event),
                    "the tag " + Problem.printable(tag.get(), 60) + " is not allowed: a scene file names no types");
        }
    }

    private Place place(Event event) {
        return place(source, event.getStartMark());
    }

    static Place place(String source, Optional<Mark> mark) {
        return mark.map(at -> new Place(source, at.getLine() + 1, at.getColumn() + 1))
                .orElse(Place.of(source));
    }

    /** A complete value that an alias may name, with the number of values in it. */
    private record Anchored(Node node, long size) {}

    /** A list or mapping whose end has not been seen. */
    private static final class Open {
        private final Place place;
        private final boolean mapping;
        private final Anchor anchor;
        private final long valuesBefore;
        private final List<Node> items = new ArrayList<>();
        private final List<Entry> entries = new ArrayList<>();
        private Scalar key;

        Open(Place place, boolean mapping, Anchor anchor, long valuesBefore) {
            this.place = place;
            this.mapping = mapping;
            this.anchor = anchor;
            this.valuesBefore = valuesBefore;
        }

        void add(Node node) {
            if (!mapping) {
                items.add(node);
            } else if (key != null) {
                entries.add(new Entry(key, node));
                key = null;
            } else if (node instanceof Scalar scalar) {
                key = scalar;
            } else {
                throw new Refused(node.place(), "a key must be text, found " + node.describe());
            }
        }

        Node toNode() {
            return mapping ? new Mapping(place, entries) : new Sequence(place, items);
        }
    }

    /** Ends the reading of a document that breaks a rule of ours. */
    private static final class Refused extends RuntimeException {
        private static final long serialVersionUID = 1;

        private final transient Place place;

        Refused(Place place, String message) {
            super(message, null, false, false);
            this.place = place;
        }
    }
}
