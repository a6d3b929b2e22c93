package mmneat.mspacman;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import mmneat.GoldenData;
import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.modules.ModuleDivisions;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import pacman.game.GhostLocations;

/** One of the original's recorded evaluations: a network, a seed and the result. */
record GoldenEvaluation(JsonNode json) {

    private static final ObjectMapper MAPPER = new ObjectMapper();

    static List<GoldenEvaluation> all() throws IOException {
        List<GoldenEvaluation> all = new ArrayList<>();
        for (String line : Files.readAllLines(GoldenData.folder("sensors").resolve("evaluations.jsonl"))) {
            all.add(new GoldenEvaluation(MAPPER.readTree(line)));
        }
        return all;
    }

    static GoldenEvaluation named(String name) throws IOException {
        return all().stream()
                .filter(evaluation -> evaluation.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    static GhostLocations ghostLocations() throws IOException {
        Path file = GoldenData.folder("ghost-locations").resolve("PowerPillToGhostLocationMapping.txt");
        try (var text = Files.newBufferedReader(file)) {
            return GhostLocations.read(file.toString(), text);
        }
    }

    String name() {
        return json.get("name").asText();
    }

    long globalSeed() {
        return json.get("globalSeed").asLong();
    }

    MsPacManTaskSettings settings() throws IOException {
        return settings(ghostLocations());
    }

    MsPacManTaskSettings settings(GhostLocations locations) {
        MsPacManTaskSettings settings =
                switch (json.get("version").asText()) {
                    case "blended" -> MsPacManTaskSettings.blended();
                    case "interleaved" -> MsPacManTaskSettings.interleaved();
                    default -> MsPacManTaskSettings.isolated(locations);
                };
        for (JsonNode parameter : json.get("parameters")) {
            if (parameter.asText().startsWith("pacmanMultitaskScheme:")) {
                // The recordings leave out the first part of the package.
                ModuleDivision division =
                        ModuleDivisions.named(parameter.asText().replaceFirst("pacmanMultitaskScheme:.*\\.", ""));
                settings = settings.withNetworks(networks -> networks.withDivision(division));
            }
        }
        return settings.withTrials(json.get("trials").asInt());
    }

    Genotype genotype() {
        int inputs = json.get("numInputs").asInt();
        int outputs = json.get("numOutputs").asInt();
        List<NodeGene> nodes = new ArrayList<>();
        for (int i = 0; i < inputs + outputs; i++) {
            nodes.add(new NodeGene(-1 - i, i < inputs ? NodeType.INPUT : NodeType.OUTPUT, ActivationFunction.TANH));
        }
        List<LinkGene> links = new ArrayList<>();
        for (JsonNode link : json.get("links")) {
            links.add(new LinkGene(
                    links.size(),
                    -1 - link.get(0).asInt(),
                    -1 - link.get(1).asInt(),
                    link.get(2).asDouble(),
                    false));
        }
        int modules = json.get("numModules").asInt();
        ModuleLayout layout =
                new ModuleLayout(outputs, modules, 1, json.get("multitask").asBoolean());
        return new Genotype(1, inputs, layout, nodes, links, new int[modules]);
    }

    double[] doubles(String field) {
        return doubles(json.get(field));
    }

    static double[] doubles(JsonNode array) {
        double[] values = new double[array.size()];
        for (int i = 0; i < values.length; i++) {
            values[i] = array.get(i).asDouble();
        }
        return values;
    }

    int[] ints(String field) {
        int[] values = new int[json.get(field).size()];
        for (int i = 0; i < values.length; i++) {
            values[i] = json.get(field).get(i).asInt();
        }
        return values;
    }
}
