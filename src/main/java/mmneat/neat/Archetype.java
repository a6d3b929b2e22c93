package mmneat.neat;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Objects;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * The population-wide list of neurons that fixes their order: the node list of every genotype is a subsequence of it.
 * The exception is full module mutation, which puts new modules before old ones.
 *
 * <p>It also holds shadow entries, which match no neuron of any network. The original adds them for a crossover that
 * combines two networks of one module each; the published experiments never perform it. The shadows are kept because
 * they use up innovation numbers and are counted in the logs.
 *
 * <p>Source: docs/specification/networks.md, sections 4.2 and 4.3; docs/specification/evolution.md, section 3.3.
 */
public final class Archetype {

    private final List<NodeGene> entries;
    /** The innovations of the entries, for a fast look-up. */
    private final Set<Long> innovations = new HashSet<>();

    /** Maps the innovation of a spliced neuron to that of its shadow. */
    private final NavigableMap<Long, Long> shadows;

    private int outputs;

    private Archetype(Collection<NodeGene> entries, Map<Long, Long> shadows) {
        this.entries = new ArrayList<>(entries);
        entries.forEach(entry -> innovations.add(entry.innovation()));
        this.shadows = new TreeMap<>(shadows);
        this.outputs = countOutputs();
    }

    /** Creates the archetype of a population whose networks all start with these neurons. */
    static Archetype startingWith(List<NodeGene> nodes) {
        return new Archetype(nodes, Map.of());
    }

    /** Restores an archetype from its state. */
    public static Archetype resume(State state) {
        return new Archetype(state.entries(), state.shadows());
    }

    /** Returns the complete state. */
    public State state() {
        return new State(entries, shadows);
    }

    /** Number of entries, shadows included. */
    public int size() {
        return entries.size();
    }

    /** Entries in order, shadows included; a view. */
    public List<NodeGene> entries() {
        return Collections.unmodifiableList(entries);
    }

    /**
     * Maps neurons spliced into networks of one module to their shadows, in ascending order; a view. The original saves
     * it as {@code combiningCrossoverMapping.txt} if it is not empty, one line "neuron shadow" per entry.
     */
    public SortedMap<Long, Long> shadows() {
        return Collections.unmodifiableSortedMap(shadows);
    }

    /**
     * Inserts a neuron that was spliced into a link, by the same rule as in its network.
     *
     * @return the position of the new entry
     */
    public int insertSpliced(NodeGene neuron, long linkSource, int inputs) {
        int position = Math.min(firstOutput(), Math.max(inputs, indexOf(linkSource) + 1));
        entries.add(position, neuron);
        innovations.add(neuron.innovation());
        return position;
    }

    /** Whether a neuron just inserted at this position needs a shadow, given that its network has one module. */
    public boolean needsShadow(int position) {
        NodeGene previous = entries.get(position - 1);
        return previous.type() == NodeType.INPUT || shadows.containsKey(previous.innovation());
    }

    /** Adds the shadow of the neuron at a position: behind the previous neuron's shadow, or before all of them. */
    public void insertShadow(int position, long shadowInnovation) {
        NodeGene neuron = entries.get(position);
        NodeGene previous = entries.get(position - 1);
        int shadowPosition = previous.type() == NodeType.INPUT
                ? firstShadowOrOutput()
                : indexOf(shadows.get(previous.innovation())) + 1;
        entries.add(
                shadowPosition,
                new NodeGene(shadowInnovation, neuron.type(), neuron.activation(), neuron.frozen(), true));
        innovations.add(shadowInnovation);
        shadows.put(neuron.innovation(), shadowInnovation);
    }

    /** Appends an output neuron of a new module, unless the archetype already contains it. */
    void addOutput(NodeGene output) {
        if (innovations.add(output.innovation())) {
            entries.add(output);
            outputs++;
        }
    }

    /** Returns the position in the network of its first neuron that the archetype lacks; -1 if it lacks none. */
    int firstUnknown(Genotype genotype) {
        List<NodeGene> nodes = genotype.nodes();
        for (int i = 0; i < nodes.size(); i++) {
            if (!innovations.contains(nodes.get(i).innovation())) {
                return i;
            }
        }
        return -1;
    }

    /** Removes the entries that no member of the population uses; a shadow is removed with its neuron. */
    public void clean(Collection<Genotype> population) {
        Set<Long> used = new HashSet<>();
        for (Genotype genotype : population) {
            for (NodeGene node : genotype.nodes()) {
                used.add(node.innovation());
            }
        }
        Map<Long, Long> neuronOfShadow = new HashMap<>();
        shadows.forEach((neuron, shadow) -> neuronOfShadow.put(shadow, neuron));
        entries.removeIf(entry -> {
            long innovation = entry.innovation();
            Long neuron = neuronOfShadow.get(innovation);
            if (used.contains(innovation) || (neuron != null && innovations.contains(neuron))) {
                return false;
            }
            innovations.remove(innovation);
            shadows.remove(neuron == null ? innovation : neuron);
            return true;
        });
        outputs = countOutputs();
    }

    private int firstOutput() {
        return entries.size() - outputs;
    }

    private int firstShadowOrOutput() {
        int position = 0;
        while (position < firstOutput() && !entries.get(position).fromCombiningCrossover()) {
            position++;
        }
        return position;
    }

    private int indexOf(long innovation) {
        for (int i = 0; i < entries.size(); i++) {
            if (entries.get(i).innovation() == innovation) {
                return i;
            }
        }
        return -1;
    }

    private int countOutputs() {
        return (int) entries.stream().filter(e -> e.type() == NodeType.OUTPUT).count();
    }

    /**
     * State of an archetype between two reproductions.
     *
     * @param entries entries in order, shadows included
     * @param shadows map from the innovation of a spliced neuron to that of its shadow
     */
    public record State(List<NodeGene> entries, SortedMap<Long, Long> shadows) {
        /**
         * A state with copies of both.
         *
         * @throws NullPointerException if a part is missing; the message names it
         */
        public State {
            entries = List.copyOf(Objects.requireNonNull(entries, "entries"));
            shadows = Collections.unmodifiableSortedMap(new TreeMap<>(Objects.requireNonNull(shadows, "shadows")));
        }

        /**
         * Checks that the entries are distinct and ordered (inputs, hidden neurons, outputs), and that shadows are
         * entries.
         */
        void requireOrder() {
            Set<Long> innovations = new HashSet<>();
            NodeType last = NodeType.INPUT;
            for (NodeGene entry : entries) {
                if (!innovations.add(entry.innovation())) {
                    throw new IllegalArgumentException("archetype: neuron " + entry.innovation() + " occurs twice");
                }
                if (entry.type().compareTo(last) < 0) {
                    throw new IllegalArgumentException("archetype: neuron " + entry.innovation() + " of type "
                            + entry.type() + " stands behind one of type " + last);
                }
                last = entry.type();
            }
            shadows.forEach((neuron, shadow) -> {
                if (shadow == null || !innovations.contains(neuron) || !innovations.contains(shadow)) {
                    throw new IllegalArgumentException(
                            "archetype: neuron " + neuron + " and its shadow " + shadow + " are not both entries");
                }
                if (neuron.equals(shadow)) {
                    throw new IllegalArgumentException("archetype: neuron " + neuron + " is its own shadow");
                }
            });
        }

        /** Checks that the inputs and hidden neurons of a genotype have the same order as here. */
        void requireSameOrder(Genotype genotype) {
            int next = 0;
            for (NodeGene neuron : genotype.nodes().subList(0, genotype.firstOutput())) {
                while (next < entries.size() && entries.get(next).innovation() != neuron.innovation()) {
                    next++;
                }
                if (next == entries.size()) {
                    throw new IllegalArgumentException("archetype: neuron " + neuron.innovation() + " of genotype "
                            + genotype.id() + " stands in another place than in the genotype");
                }
            }
        }
    }
}
