package mmneat.neat.io;

import com.fasterxml.jackson.annotation.JsonInclude;
import com.fasterxml.jackson.annotation.JsonProperty;
import com.fasterxml.jackson.annotation.JsonPropertyOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import org.jspecify.annotations.Nullable;

/** The JSON document of a genotype, with its fields in order; docs/genotype-format.md describes them. */
@JsonPropertyOrder({
    "format",
    "version",
    "id",
    "inputs",
    "outputs",
    "modules",
    "policyNeuronsPerModule",
    "standardMultitask",
    "groups",
    "moduleUsage",
    "nodes",
    "links"
})
record GenotypeDocument(
        @JsonProperty(required = true) String format,
        @JsonProperty(required = true) int version,
        @JsonProperty(required = true) long id,
        @JsonProperty(required = true) int inputs,
        @JsonProperty(required = true) int outputs,
        @JsonProperty(required = true) int modules,
        @JsonProperty(required = true) int policyNeuronsPerModule,
        @JsonProperty(required = true) boolean standardMultitask,
        @JsonInclude(JsonInclude.Include.NON_EMPTY) List<Integer> groups,
        @JsonProperty(required = true) int[] moduleUsage,
        @JsonProperty(required = true) List<Node> nodes,
        @JsonProperty(required = true) List<Link> links) {

    static final String FORMAT = "mmneat-genotype";
    static final int VERSION = 1;

    GenotypeDocument {
        requireFormat(format);
        requireVersion(version);
        groups = groups == null ? List.of() : groups;
        for (int i = 0; i < groups.size(); i++) {
            requirePresent("groups[" + i + "]", groups.get(i));
        }
        requirePresent("moduleUsage", moduleUsage);
        requirePresent("nodes", nodes);
        requirePresent("links", links);
    }

    static void requireFormat(String format) {
        if (!FORMAT.equals(format)) {
            throw new IllegalArgumentException("format: must be \"" + FORMAT + "\", is \"" + format + "\"");
        }
    }

    static void requireVersion(int version) {
        if (version != VERSION) {
            throw new IllegalArgumentException(
                    "version: this program reads version " + VERSION + ", the file has " + version);
        }
    }

    static GenotypeDocument of(Genotype genotype) {
        ModuleLayout layout = genotype.layout();
        return new GenotypeDocument(
                FORMAT,
                VERSION,
                genotype.id(),
                genotype.inputs(),
                layout.outputs(),
                layout.modules(),
                layout.policyNeuronsPerModule(),
                layout.standardMultitask(),
                layout.groups(),
                genotype.moduleUsage(),
                genotype.nodes().stream().map(Node::of).toList(),
                genotype.links().stream().map(Link::of).toList());
    }

    /** Returns the genotype. An {@link IllegalArgumentException} names the invalid field. */
    Genotype toGenotype() {
        List<NodeGene> nodeGenes = new ArrayList<>(nodes.size());
        for (int i = 0; i < nodes.size(); i++) {
            requirePresent("nodes[" + i + "]", nodes.get(i));
            nodeGenes.add(nodes.get(i).toGene(i));
        }
        List<LinkGene> linkGenes = new ArrayList<>(links.size());
        for (int i = 0; i < links.size(); i++) {
            requirePresent("links[" + i + "]", links.get(i));
            linkGenes.add(links.get(i).toGene());
        }
        requireUsageOfModules(moduleUsage, modules);
        ModuleLayout layout = new ModuleLayout(outputs, modules, policyNeuronsPerModule, standardMultitask, groups);
        return new Genotype(id, inputs, layout, nodeGenes, linkGenes, moduleUsage);
    }

    /**
     * Checks that there are not more counts than modules: a network may have gained modules since its evaluation, but
     * not lost one.
     */
    static void requireUsageOfModules(int[] usage, int modules) {
        if (usage.length > modules) {
            throw new IllegalArgumentException(
                    "moduleUsage: has " + usage.length + " numbers, more than the " + modules + " modules");
        }
    }

    private static void requirePresent(String field, Object value) {
        if (value == null) {
            throw new IllegalArgumentException(field + ": is null");
        }
    }

    /** A neuron. */
    @JsonPropertyOrder({"innovation", "type", "activation", "frozen"})
    record Node(
            @JsonProperty(required = true) long innovation,
            @JsonProperty(required = true) String type,
            @JsonProperty(required = true) String activation,

            @JsonInclude(JsonInclude.Include.NON_NULL) @Nullable
            Boolean frozen) {

        static Node of(NodeGene gene) {
            return new Node(
                    gene.innovation(),
                    gene.type().name().toLowerCase(Locale.ROOT),
                    FunctionNames.of(gene.activation()),
                    gene.frozen() ? true : null);
        }

        NodeGene toGene(int index) {
            return new NodeGene(innovation, typeOf(index), functionOf(index), Boolean.TRUE.equals(frozen), false);
        }

        private NodeType typeOf(int index) {
            List<String> names = new ArrayList<>();
            for (NodeType each : NodeType.values()) {
                names.add(each.name().toLowerCase(Locale.ROOT));
                if (names.get(names.size() - 1).equals(type)) {
                    return each;
                }
            }
            throw new IllegalArgumentException(
                    "nodes[" + index + "].type: must be one of " + String.join(", ", names) + ", is \"" + type + "\"");
        }

        private ActivationFunction functionOf(int index) {
            try {
                return FunctionNames.read(activation);
            } catch (IllegalArgumentException e) {
                throw new IllegalArgumentException("nodes[" + index + "].activation: " + e.getMessage(), e);
            }
        }
    }

    /** A connection. */
    @JsonPropertyOrder({"innovation", "source", "target", "weight", "active", "recurrent", "frozen"})
    record Link(
            @JsonProperty(required = true) long innovation,
            @JsonProperty(required = true) long source,
            @JsonProperty(required = true) long target,
            @JsonProperty(required = true) double weight,
            @JsonProperty(required = true) boolean active,
            @JsonProperty(required = true) boolean recurrent,

            @JsonInclude(JsonInclude.Include.NON_NULL) @Nullable
            Boolean frozen) {

        static Link of(LinkGene gene) {
            return new Link(
                    gene.innovation(),
                    gene.source(),
                    gene.target(),
                    gene.weight(),
                    gene.active(),
                    gene.recurrent(),
                    gene.frozen() ? true : null);
        }

        LinkGene toGene() {
            return new LinkGene(innovation, source, target, weight, active, recurrent, Boolean.TRUE.equals(frozen));
        }
    }
}
