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
 * Crossover and the splice of neurons rely on this order. There is one exception: outputs that full module mutation
 * added (a module linked to all inputs) are numbered in another way. In a genotype they can stand before outputs that
 * stand before them here.
 *
 * <p>The list also has shadow entries, which match no neuron of any network. The original prepares with them a
 * crossover that combines two networks of one module each, in which the neurons of the second network need entries of
 * their own. No experiment performs that crossover. The shadows are kept because they use up innovation numbers and are
 * counted in the logs.
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
     * Inserts a neuron that was spliced into a link. The rule is the same as in the network of the neuron: directly
     * behind the source of the link; if the source is an input, directly behind all inputs; if it is an output, before
     * all outputs.
     *
     * @param neuron the new hidden neuron
     * @param linkSource innovation of the neuron from which the link came
     * @param inputs number of input neurons
     * @return the position of the new entry
     */
    public int insertSpliced(NodeGene neuron, long linkSource, int inputs) {
        int position = Math.min(firstOutput(), Math.max(inputs, indexOf(linkSource) + 1));
        entries.add(position, neuron);
        innovations.add(neuron.innovation());
        return position;
    }

    /**
     * Whether a neuron that was just inserted at a position gets a shadow, if its network has one module. The rule of
     * the original: the entry before it is an input, or has a shadow itself, which then tells the place of the new
     * shadow.
     */
    public boolean needsShadow(int position) {
        NodeGene previous = entries.get(position - 1);
        return previous.type() == NodeType.INPUT || shadows.containsKey(previous.innovation());
    }

    /**
     * Adds the shadow of the neuron at a position. It comes directly behind the shadow of the entry before that neuron.
     * If the entry before it is an input, which has no shadow, it comes before all other shadows.
     *
     * @param position position of a neuron for which {@link #needsShadow} is true
     * @param shadowInnovation innovation number of the shadow
     */
    public void insertShadow(int position, long shadowInnovation) {
        NodeGene neuron = entries.get(position);
        NodeGene previous = entries.get(position - 1);
        int shadowPosition = previous.type() == NodeType.INPUT
                ? firstShadowOrOutput()
                : indexOf(Objects.requireNonNull(shadows.get(previous.innovation()))) + 1;
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
                            + entry.type() + " follows a neuron of type " + last);
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
                            + genotype.id() + " has a different position than in the genotype");
                }
            }
        }
    }
}
