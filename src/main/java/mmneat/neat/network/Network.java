package mmneat.neat.network;

import java.util.Arrays;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import org.jspecify.annotations.Nullable;

/**
 * A genotype compiled for activation: immutable, and shared by any number of {@link NetworkState}s and threads.
 *
 * <p>Source: docs/specification/networks.md, section 5.
 */
public final class Network {

    /*
     * The original pushes: every node, in the genotype's order, adds its activation times a weight to the pending sums
     * of its targets. Here every neuron pulls instead. A sum then is one loop over adjacent weights, and a neuron whose
     * activation is not read can wait. The result is the same to the last bit if a neuron's addends keep their order:
     *
     *   1. recurrent links (source at or behind the target) by source, with the source's activation of the previous
     *   step;
     *   2. forward links by source, with the activation of this step.
     *
     * The links of a neuron lie side by side in that order. A state keeps the activations of the previous step behind
     * those of this one, so that a recurrent link is a link like any other.
     *
     * Only the order within a sum counts, so neurons can be computed in any order that has a neuron's forward sources
     * before it, and those that are not needed not at all. They are grouped by what they are needed for:
     *
     *   always   what later steps read: sources of recurrent links, and what these depend on;
     *   shared   what more than one module's answer or the choice of the module depends on;
     *   modules  what the answer of one module alone depends on: a module that loses the choice costs nothing.
     *
     * Within a group neurons are ordered by level: their forward sources all lie on lower levels, and those of one
     * level are independent of each other. Outputs that no link reads come last and are computed only when they are
     * asked for ("lazy").
     *
     * Activations serve decisions: which module has the highest preference, which state the highest answer. Mostly
     * they are far enough apart to be told from rough values (RoughTanh); the margin, found when compiling, says how
     * far a rough sum can be from the exact one. Where that does not settle it, and whenever a value is read, the exact
     * one is computed.
     *
     * What later steps read may be rough, too, if recurrent links do not let the difference grow without bound. A state
     * then keeps the activations of many steps. For an exact value it computes what later steps read once more, from
     * the last exact step on. A flush mostly comes before that is ever needed. In other networks, what later steps read
     * is always exact.
     *
     * Slots number what has an activation: first all inputs, then the neurons in that order. Nodes from which no output
     * can be reached in any number of steps have no slot.
     */

    /** Slot of a node that takes no part. */
    static final int LEFT_OUT = -1;

    /** Group of neurons that later steps need. */
    static final int ALWAYS = 0;

    /** Group of neurons that more than one module, or the choice of a module, needs. */
    static final int SHARED = 1;

    /** Group of neurons that only module 0's answer needs; those of the other modules follow. */
    static final int FIRST_MODULE = 2;

    /** Networks of so large weights that rough sums could be farther off are never computed roughly. */
    static final double LARGEST_MARGIN = 1e-3;

    final int inputs;
    final ModuleLayout layout;
    /** Slot of each node, by position in the genotype. */
    final int[] slotOfNode;
    /** Slot of each output neuron, by output number. */
    final int[] slotOfOutput;
    /** Slot of each module's preference neuron; empty if modules have none. */
    final int[] slotOfPreference;
    /** Whether sums can tell which module is preferred: of several, tanh, and not all exact anyway. */
    final boolean prefersBySums;
    /** Number of slots; the neurons are [inputs, slots). */
    final int slots;
    /** Neurons from this slot on are lazy. */
    final int firstLazy;
    /** First slot of each group of the neurons that are not lazy, and {@link #firstLazy} at the end. */
    final int[] groupStart;
    /** Group of each output neuron, by output number, lazy or not. */
    final int[] groupOfOutput;
    /** Whether what later steps read may be rough: there are recurrent links, and the margin holds with them. */
    final boolean isRoughThroughout;
    /** How far a rough sum can be from the exact one. */
    final double margin;
    /**
     * Number of neurons, from the first slot of neurons on, whose activation of the previous step a state remembers.
     */
    final int remembered;
    /** Per slot: where its links start in the two arrays below; one more entry at the end. */
    final int[] linkStart;

    /**
     * The slot that a forward link comes from; for a recurrent one, of which {@link #slots} plus the number of the
     * neuron.
     */
    final int[] linkSource;

    final double[] linkWeight;
    /** Function of each slot; null if all are tanh. */
    final ActivationFunction @Nullable [] functions;

    Network(
            Genotype genotype,
            int[] slotOfNode,
            int[] groupStart,
            int[] groupOfOutput,
            boolean isRoughThroughout,
            double margin,
            int remembered,
            int[] linkStart,
            int[] linkSource,
            double[] linkWeight,
            ActivationFunction @Nullable [] functions) {
        this.inputs = genotype.inputs();
        this.layout = genotype.layout();
        this.slotOfNode = slotOfNode;
        this.slots = linkStart.length - 1;
        this.groupStart = groupStart;
        this.groupOfOutput = groupOfOutput;
        this.isRoughThroughout = isRoughThroughout;
        this.margin = margin;
        this.firstLazy = groupStart[groupStart.length - 1];
        this.remembered = remembered;
        this.linkStart = linkStart;
        this.linkSource = linkSource;
        this.linkWeight = linkWeight;
        this.functions = functions;
        slotOfOutput = new int[layout.outputs()];
        System.arraycopy(slotOfNode, genotype.firstOutput(), slotOfOutput, 0, slotOfOutput.length);
        slotOfPreference = new int[layout.hasPreferenceNeurons() ? layout.modules() : 0];
        Arrays.setAll(slotOfPreference, module -> slotOfOutput[layout.preferenceOutput(module)]);
        prefersBySums = functions == null
                && slotOfPreference.length > 1
                && (isRoughThroughout || !Arrays.stream(slotOfPreference).allMatch(this::isAlwaysComputed));
    }

    /**
     * The network of a genotype, without the nodes from which no output can be reached.
     *
     * @throws mmneat.neat.BadPartException if it has an activation function of the user's own whose class has not been
     *     loaded
     */
    public static Network compile(Genotype genotype) {
        return new NetworkCompiler(genotype, false).compile();
    }

    /**
     * The network of a genotype with every node, also those that have no effect on any output: to show all activations.
     * Outputs are equal to those of {@link #compile}.
     *
     * @throws mmneat.neat.BadPartException as {@link #compile}
     */
    public static Network compileWithAllNodes(Genotype genotype) {
        return new NetworkCompiler(genotype, true).compile();
    }

    /**
     * A new state of this network: all activations, pending sums of recurrent links and counts are 0. The module with
     * the highest preference answers.
     */
    public NetworkState newState() {
        return new NetworkState(this, ModuleArbitration.PREFERENCE);
    }

    /**
     * A new state of this network whose modules are chosen in another way.
     *
     * @throws IllegalArgumentException if the arbitration does not suit the network's modules
     */
    public NetworkState newState(ModuleArbitration arbitration) {
        return new NetworkState(this, arbitration);
    }

    /**
     * New states of this network that are activated together, such as one per direction; modules by plain preference.
     *
     * @throws IllegalArgumentException if {@code count} is not 1 to 31
     */
    public NetworkStates newStates(int count) {
        return newStates(count, ModuleArbitration.PREFERENCE);
    }

    /**
     * New states of this network that are activated together and whose modules are chosen in another way.
     *
     * @throws IllegalArgumentException if the arbitration does not suit the network's modules, or {@code count} is not
     *     1 to 31
     */
    public NetworkStates newStates(int count, ModuleArbitration arbitration) {
        return new NetworkStates(this, count, arbitration);
    }

    /** Number of input values. */
    public int inputs() {
        return inputs;
    }

    /** How the outputs are divided into modules. */
    public ModuleLayout layout() {
        return layout;
    }

    /** Number of output modules. */
    public int modules() {
        return layout.modules();
    }

    /** Number of nodes of the genotype, left-out ones included. */
    public int nodes() {
        return slotOfNode.length;
    }

    boolean isAlwaysComputed(int slot) {
        return slot < groupStart[ALWAYS + 1];
    }

    int firstOutput() {
        return slotOfNode.length - slotOfOutput.length;
    }

    /**
     * Whether the node at this position of {@link Genotype#nodes()} is part of the network: it has an activation.
     *
     * @throws IllegalArgumentException if the genotype has no such node
     */
    public boolean hasNode(int position) {
        if (position < 0 || position >= slotOfNode.length) {
            throw new IllegalArgumentException(
                    "node must be one of the genotype's " + slotOfNode.length + ", is " + position);
        }
        return slotOfNode[position] != LEFT_OUT;
    }

    /** Number of neurons (hidden and output) that take part. */
    public int neurons() {
        return slots - inputs;
    }

    /** Number of links that take part. */
    public int links() {
        return linkSource.length;
    }
}
