package mmneat.neat.variation;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import mmneat.GoldenData;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Archetype;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;

/** Reads the records that are common to the files of {@code golden/networks}; its README describes them. */
public final class GoldenGenotypes {

    private static final ObjectMapper MAPPER = new ObjectMapper();

    private GoldenGenotypes() {}

    /** A file of {@code golden/networks}. */
    public static JsonNode file(String name) {
        try {
            return MAPPER.readTree(
                    GoldenData.folder("networks").resolve(name + ".json").toFile());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public static List<JsonNode> elements(JsonNode array) {
        List<JsonNode> elements = new ArrayList<>();
        array.forEach(elements::add);
        return elements;
    }

    public static Genotype genotype(JsonNode record) {
        ModuleLayout layout = new ModuleLayout(
                record.required("num_out").intValue(),
                record.required("num_modules").intValue(),
                record.required("policy_neurons_per_module").intValue(),
                record.required("standard_multitask").booleanValue());
        List<NodeGene> nodes = new ArrayList<>();
        for (JsonNode row : record.required("nodes")) {
            nodes.add(new NodeGene(
                    row.get(0).longValue(),
                    NodeType.ofCode(row.get(1).intValue()),
                    ActivationFunction.ofCode(row.get(2).intValue()),
                    row.get(3).intValue() == 1,
                    false));
        }
        List<LinkGene> links = new ArrayList<>();
        for (JsonNode row : record.required("links")) {
            links.add(new LinkGene(
                    row.get(0).longValue(),
                    row.get(1).longValue(),
                    row.get(2).longValue(),
                    row.get(3).doubleValue(),
                    row.get(4).intValue() == 1,
                    row.get(5).intValue() == 1,
                    row.get(6).intValue() == 1));
        }
        return new Genotype(
                record.required("id").longValue(),
                record.required("num_in").intValue(),
                layout,
                nodes,
                links,
                MAPPER.convertValue(record.required("module_usage"), int[].class));
    }

    public static GenePool.State state(JsonNode record) {
        Map<Long, Long> shadows = new TreeMap<>();
        Iterator<Map.Entry<String, JsonNode>> fields =
                record.required("shadow_map").fields();
        while (fields.hasNext()) {
            Map.Entry<String, JsonNode> field = fields.next();
            shadows.put(Long.valueOf(field.getKey()), field.getValue().longValue());
        }
        return new GenePool.State(
                record.required("next_innovation").longValue(),
                record.required("next_genotype_id").longValue(),
                new Archetype.State(archetype(record.required("archetype")), new TreeMap<>(shadows)));
    }

    public static List<NodeGene> archetype(JsonNode rows) {
        List<NodeGene> entries = new ArrayList<>();
        for (JsonNode row : rows) {
            entries.add(new NodeGene(
                    row.get(0).longValue(),
                    NodeType.ofCode(row.get(1).intValue()),
                    ActivationFunction.TANH,
                    false,
                    row.get(2).intValue() == 1));
        }
        return entries;
    }

    /** The value of a parameter among "name:value" texts, or a default. */
    public static double parameter(JsonNode parameters, String name, double otherwise) {
        for (JsonNode parameter : parameters) {
            String[] parts = parameter.textValue().split(":", 2);
            if (parts[0].equals(name)) {
                return Double.parseDouble(parts[1]);
            }
        }
        return otherwise;
    }

    /** The mutation rates of a case. */
    public static MutationRates rates(JsonNode parameters) {
        return MutationRates.PUBLISHED.withModuleDuplication(parameter(parameters, "mmdRate", 0));
    }
}
