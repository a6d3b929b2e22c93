package mmneat.neat;

import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;

/**
 * The genes of a network: node genes in activation order, link genes, and the division of outputs into modules.
 *
 * <p>Immutable. Nodes are the inputs, then the hidden neurons, then the outputs. The order of links does not change the
 * network's outputs (beyond rounding), but it decides which link a random index selects. Inactive links are not part of
 * the network. A node and a link may have the same innovation number: new ones share one counter, but inputs, outputs
 * and initial links are numbered downwards from -1.
 *
 * <p>Source: docs/specification/networks.md, section 3.
 */
public final class Genotype {

    private final long id;
    private final int inputs;
    private final ModuleLayout layout;
    private final List<NodeGene> nodes;
    private final List<LinkGene> links;
    private final int[] moduleUsage;
    /** Made when it is first needed; immutable, so that threads may share it. */
    private @Nullable NodePositions positions;

    /**
     * A checked genotype.
     *
     * @param id number of this individual in its run
     * @param inputs number of input neurons
     * @param layout division of the outputs into modules
     * @param nodes node genes in activation order: inputs, hidden, outputs; no shadow entries of an archetype
     * @param links link genes; no two with the same innovation or the same end points, none into an input
     * @param moduleUsage how often each module was chosen in the last evaluation. An offspring has the counts of its
     *     parent until it is evaluated. So a module that mutation added has no count yet, and the array is shorter than
     *     the number of modules
     * @throws IllegalArgumentException if the genes do not form a network; the message says where
     * @throws NullPointerException if a part is missing; the message names it
     */
    public Genotype(
            long id, int inputs, ModuleLayout layout, List<NodeGene> nodes, List<LinkGene> links, int[] moduleUsage) {
        this(
                id,
                inputs,
                Objects.requireNonNull(layout, "layout"),
                List.copyOf(Objects.requireNonNull(nodes, "nodes")),
                List.copyOf(Objects.requireNonNull(links, "links")),
                Objects.requireNonNull(moduleUsage, "moduleUsage").clone(),
                true);
    }

    /** A genotype from genes that are known to be valid; they are checked only if assertions are enabled. */
    static Genotype unchecked(
            long id, int inputs, ModuleLayout layout, List<NodeGene> nodes, List<LinkGene> links, int[] moduleUsage) {
        boolean check = false;
        assert check = true;
        return new Genotype(id, inputs, layout, List.copyOf(nodes), List.copyOf(links), moduleUsage.clone(), check);
    }

    private Genotype(
            long id,
            int inputs,
            ModuleLayout layout,
            List<NodeGene> nodes,
            List<LinkGene> links,
            int[] moduleUsage,
            boolean check) {
        this.id = id;
        this.inputs = inputs;
        this.layout = layout;
        this.nodes = nodes;
        this.links = links;
        this.moduleUsage = moduleUsage;
        if (check) {
            requireNodesInOrder();
            requireLinksBetweenNodes();
            requireUsageCounts();
        }
    }

    /** Number of this individual in its run. */
    public long id() {
        return id;
    }

    /** Number of input neurons. */
    public int inputs() {
        return inputs;
    }

    /** Number of hidden neurons. */
    public int hidden() {
        return nodes.size() - inputs - layout.outputs();
    }

    /** Number of output neurons: policy neurons and, if there are any, preference neurons ({@link ModuleLayout}). */
    public int outputs() {
        return layout.outputs();
    }

    /** Number of output modules. */
    public int modules() {
        return layout.modules();
    }

    /** Division of the outputs into modules. */
    public ModuleLayout layout() {
        return layout;
    }

    /** Node genes in activation order: inputs, hidden, outputs. Unmodifiable, with fast random access. */
    public List<NodeGene> nodes() {
        return nodes;
    }

    /** Link genes, inactive ones included. Unmodifiable, with fast random access. */
    public List<LinkGene> links() {
        return links;
    }

    /** The positions of the neurons in {@link #nodes()}. */
    public NodePositions positions() {
        NodePositions known = positions;
        if (known == null) {
            known = new NodePositions(nodes);
            positions = known;
        }
        return known;
    }

    /** Position in {@link #nodes()} of the first output. */
    public int firstOutput() {
        return nodes.size() - layout.outputs();
    }

    /** How often each module was chosen in the last evaluation (a copy). */
    public int[] moduleUsage() {
        return moduleUsage.clone();
    }

    /** The names of the user's own activation functions whose classes have not been loaded, sorted. */
    public SortedSet<String> unboundFunctions() {
        SortedSet<String> names = new TreeSet<>();
        for (NodeGene node : nodes) {
            if (!node.activation().isBound()) {
                names.add(node.activation().name());
            }
        }
        return names;
    }

    /** Returns the first activation function of the user's own in this genotype that is not the allowed one. */
    public Optional<ActivationFunction> ownFunctionOtherThan(ActivationFunction allowed) {
        return nodes.stream()
                .map(NodeGene::activation)
                .filter(function -> function.isOwn() && !function.equals(allowed))
                .findFirst();
    }

    /** Returns this genotype with the operator applied to the activation function of each neuron. */
    public Genotype withFunctions(UnaryOperator<ActivationFunction> functions) {
        List<NodeGene> replaced = nodes.stream()
                .map(node -> node.withActivation(functions.apply(node.activation())))
                .toList();
        return new Genotype(id, inputs, layout, replaced, links, moduleUsage, false);
    }

    /**
     * Returns this genotype with new counts of how often its modules were chosen.
     *
     * @throws IllegalArgumentException if a count is negative
     */
    public Genotype withModuleUsage(int[] usage) {
        Genotype evaluated = new Genotype(id, inputs, layout, nodes, links, usage.clone(), false);
        evaluated.positions = positions;
        evaluated.requireUsageCounts();
        return evaluated;
    }

    /** The same network under another id. */
    public Genotype withId(long newId) {
        return new Genotype(newId, inputs, layout, nodes, links, moduleUsage, false);
    }

    private void requireNodesInOrder() {
        if (inputs < 1 || nodes.size() < (long) inputs + layout.outputs()) {
            throw new IllegalArgumentException("nodes: " + nodes.size() + " are too few for " + inputs + " inputs and "
                    + layout.outputs() + " outputs");
        }
        Set<Long> innovations = new HashSet<>(nodes.size() * 2);
        for (int i = 0; i < nodes.size(); i++) {
            NodeType expected = i < inputs ? NodeType.INPUT : i < firstOutput() ? NodeType.HIDDEN : NodeType.OUTPUT;
            NodeGene node = nodes.get(i);
            if (node.type() != expected) {
                throw new IllegalArgumentException("nodes[" + i + "]: must be of type " + expected + " with " + inputs
                        + " inputs and " + layout.outputs() + " outputs, is " + node.type());
            }
            if (node.fromCombiningCrossover()) {
                throw new IllegalArgumentException("nodes[" + i
                        + "].fromCombiningCrossover: must be false, as it is only for entries of an archetype");
            }
            if (!innovations.add(node.innovation())) {
                throw new IllegalArgumentException(
                        "nodes[" + i + "]: innovation " + node.innovation() + " occurs twice");
            }
        }
    }

    private void requireLinksBetweenNodes() {
        Map<Long, Integer> positions = new HashMap<>(nodes.size() * 2);
        for (int i = 0; i < nodes.size(); i++) {
            positions.put(nodes.get(i).innovation(), i);
        }
        Set<Long> innovations = new HashSet<>(links.size() * 2);
        Set<Long> endPoints = new HashSet<>(links.size() * 2);
        for (int i = 0; i < links.size(); i++) {
            LinkGene link = links.get(i);
            Integer source = positions.get(link.source());
            Integer target = positions.get(link.target());
            if (source == null || target == null) {
                throw new IllegalArgumentException(
                        "links[" + i + "]: no node has innovation " + (source == null ? link.source() : link.target()));
            }
            if (target < inputs) {
                throw new IllegalArgumentException("links[" + i + "]: leads into input " + link.target());
            }
            if (!Double.isFinite(link.weight())) {
                throw new IllegalArgumentException("links[" + i + "]: weight must be finite, is " + link.weight());
            }
            if (!innovations.add(link.innovation())) {
                throw new IllegalArgumentException(
                        "links[" + i + "]: innovation " + link.innovation() + " occurs twice");
            }
            if (!endPoints.add((long) source * nodes.size() + target)) {
                throw new IllegalArgumentException(
                        "links[" + i + "]: a second link from " + link.source() + " to " + link.target());
            }
        }
    }

    private void requireUsageCounts() {
        for (int i = 0; i < moduleUsage.length; i++) {
            if (moduleUsage[i] < 0) {
                throw new IllegalArgumentException("moduleUsage[" + i + "]: is negative: " + moduleUsage[i]);
            }
        }
    }

    /** Equal in every gene, count and id. */
    @Override
    public boolean equals(Object other) {
        return other instanceof Genotype that
                && id == that.id
                && inputs == that.inputs
                && layout.equals(that.layout)
                && nodes.equals(that.nodes)
                && links.equals(that.links)
                && Arrays.equals(moduleUsage, that.moduleUsage);
    }

    @Override
    public int hashCode() {
        return Long.hashCode(id) * 31 + links.hashCode();
    }

    @Override
    public String toString() {
        return "genotype " + id + " (" + inputs + " inputs, " + hidden() + " hidden, " + outputs() + " outputs in "
                + modules() + " modules, " + links.size() + " links)";
    }
}
