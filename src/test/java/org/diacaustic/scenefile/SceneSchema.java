package org.diacaustic.scenefile;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.OutputFormat;
import com.networknt.schema.SpecVersion;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.UnaryOperator;

/** {@code scenes/scene.schema.json}, taken apart into every position at which a scene may hold a value. */
final class SceneSchema {
    static final ObjectMapper JSON = new ObjectMapper();
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private final JsonNode root;
    private final JsonSchema validator;

    /**
     * A position in scenes.
     *
     * @param path as the scene reader writes it
     * @param schema of the value there, without references
     * @param embed a whole valid scene, with the given value there
     */
    record Site(String path, JsonNode schema, UnaryOperator<JsonNode> embed) {

        boolean isVariant() {
            return schema.has("properties") && schema.path("maxProperties").asInt() == 1;
        }

        boolean isMapping() {
            return schema.has("properties") && !isVariant();
        }

        Set<String> keys() {
            Set<String> keys = new TreeSet<>();
            schema.get("properties").fieldNames().forEachRemaining(keys::add);
            return keys;
        }

        List<String> required() {
            List<String> keys = new ArrayList<>();
            schema.path("required").forEach(key -> keys.add(key.asText()));
            return keys;
        }
    }

    SceneSchema(Path file) throws IOException {
        root = JSON.readTree(file.toFile());
        validator =
                JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012).getSchema(root);
    }

    boolean accepts(JsonNode scene) {
        return validator.validate(scene, OutputFormat.BOOLEAN);
    }

    /** What the schema has against a scene. */
    String complaints(JsonNode scene) {
        return validator.validate(scene).toString();
    }

    /** Every position; what is described once and used in many places is entered once. */
    List<Site> sites() {
        List<Site> sites = new ArrayList<>();
        collect(new Site("", root, value -> value), sites, new HashSet<>());
        return sites;
    }

    private void collect(Site site, List<Site> sites, Set<JsonNode> entered) {
        sites.add(site);
        if (!entered.add(site.schema())) {
            return;
        }
        JsonNode schema = site.schema();
        for (JsonNode alternative : schema.path("anyOf")) {
            collect(new Site(site.path(), resolved(alternative), site.embed()), sites, entered);
        }
        if (schema.path("additionalProperties").isObject()) {
            collect(
                    new Site(
                            site.path() + ".example",
                            resolved(schema.get("additionalProperties")),
                            value -> site.embed().apply(NODES.objectNode().set("example", value))),
                    sites,
                    entered);
        }
        if (schema.has("items")) {
            collect(
                    new Site(
                            site.path() + "[0]",
                            resolved(schema.get("items")),
                            value -> site.embed().apply(listWith(schema, value))),
                    sites,
                    entered);
        }
        if (schema.has("properties")) {
            for (String key : site.keys()) {
                ObjectNode around = site.isVariant() ? NODES.objectNode() : mappingWith(site, key);
                String path = site.path().isEmpty() ? key : site.path() + "." + key;
                collect(
                        new Site(
                                path,
                                property(schema, key),
                                value -> site.embed().apply(around.deepCopy().set(key, value))),
                        sites,
                        entered);
            }
        }
    }

    /** What the schema says of the value under a key, without references. */
    JsonNode property(JsonNode schema, String key) {
        return resolved(schema.get("properties").get(key));
    }

    /** The smallest mapping that the schema accepts and that has the key. */
    ObjectNode mappingWith(Site site, String key) {
        for (ObjectNode mapping : smallestMappings(site.schema())) {
            mapping.set(key, example(property(site.schema(), key)));
            if (accepts(site.embed().apply(mapping))) {
                return mapping;
            }
        }
        throw new AssertionError("no mapping at " + site.path() + " may have the key " + key);
    }

    private List<ObjectNode> smallestMappings(JsonNode schema) {
        List<ObjectNode> mappings = new ArrayList<>();
        for (JsonNode alternative : schema.path("oneOf")) {
            mappings.add(required(schema, alternative));
        }
        if (mappings.isEmpty()) {
            mappings.add(required(schema, schema));
        }
        if (schema.has("dependentRequired")) {
            for (JsonNode together : schema.get("dependentRequired")) {
                ObjectNode mapping = required(schema, schema);
                together.forEach(key -> mapping.set(key.asText(), example(property(schema, key.asText()))));
                mappings.add(mapping);
            }
        }
        return mappings;
    }

    private ObjectNode required(JsonNode schema, JsonNode alternative) {
        ObjectNode mapping = NODES.objectNode();
        for (JsonNode keys : List.of(schema.path("required"), alternative.path("required"))) {
            keys.forEach(key -> mapping.set(key.asText(), example(property(schema, key.asText()))));
        }
        return mapping;
    }

    /** Some value that the schema accepts, with nothing in it that may be left out. */
    JsonNode example(JsonNode schema) {
        if (schema.has("examples")) {
            return schema.get("examples").get(0);
        }
        for (String single : Arrays.asList("default", "const")) {
            if (schema.has(single)) {
                return schema.get(single);
            }
        }
        if (schema.has("enum")) {
            return schema.get("enum").get(0);
        }
        if (schema.has("anyOf")) {
            return example(resolved(schema.get("anyOf").get(0)));
        }
        return switch (schema.path("type").asText()) {
            case "object" -> exampleMapping(schema);
            case "array" -> listWith(schema, example(resolved(schema.get("items"))));
            case "boolean" -> NODES.booleanNode(true);
            case "string" -> NODES.textNode("example");
            default -> NODES.numberNode(1);
        };
    }

    private JsonNode exampleMapping(JsonNode schema) {
        if (schema.path("additionalProperties").isObject()) {
            return NODES.objectNode().set("example", example(resolved(schema.get("additionalProperties"))));
        }
        if (schema.has("minProperties")) {
            String first = schema.get("properties").fieldNames().next();
            return NODES.objectNode().set(first, example(property(schema, first)));
        }
        return smallestMappings(schema).get(0);
    }

    private ArrayNode listWith(JsonNode schema, JsonNode first) {
        ArrayNode list = NODES.arrayNode().add(first);
        JsonNode model = schema.path("examples").path(0);
        while (list.size() < schema.path("minItems").asInt()) {
            list.add(model.has(list.size()) ? model.get(list.size()) : example(resolved(schema.get("items"))));
        }
        return list;
    }

    /** The schema with what its reference names, over which its own keywords stand. */
    private JsonNode resolved(JsonNode schema) {
        if (!schema.has("$ref")) {
            return schema;
        }
        ObjectNode own = schema.deepCopy();
        String reference = own.remove("$ref").asText();
        ObjectNode whole = resolved(root.at(reference.substring(1))).deepCopy();
        return whole.setAll(own);
    }
}
