package mmneat.neat.network;

import java.util.Arrays;
import mmneat.random.Argmax;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;

/**
 * The mutable activations of one running copy of a {@link Network}, and a count of how often each module was chosen.
 *
 * <p>Many states can share one network; a state is not thread-safe. A step computes neurons in the order of the
 * genotype. Forward links act in the same step; a recurrent link adds to its target's pending sum, which the next step
 * starts with. After a step, and until the next step or flush, every activation can be read. A step allocates nothing.
 *
 * <p>Source: docs/specification/networks.md, sections 5.2 and 6.
 */
public final class NetworkState {

    /** Steps whose activations are kept if what later steps read is computed roughly. */
    private static final int KEPT_STEPS = 128;

    private final Network network;
    /**
     * Activation of each slot that is not lazy, as far as its group is computed; behind them the activations of the
     * previous step that recurrent links read.
     */
    private double[] activations;

    /** Activations of the last steps; {@link #activations} is the element {@link #step}. */
    private final double[][] steps;

    private int step = -1;

    /** The first of them in which {@link Network#ALWAYS} is not exact, though its recurrent links read exact values. */
    private int firstRough;

    /** Groups that were computed in this step, as a set of {@link #bit}: at least roughly, and to the last bit. */
    private long computed;

    private long exact;

    private final int[] moduleUsage;
    /** Sum or activation of each preference neuron while the module is chosen. */
    private final double[] preferences;
    /** How modules are chosen if not by plain preference, else null. */
    private final @Nullable ModuleArbiter arbiter;

    /** Whether sums of preference neurons mostly tell the preferred module. */
    private final boolean prefersBySums;

    private int presetModule;
    private int lastModule;
    /** Whether no step has been made since everything was set to 0. */
    private boolean flushed = true;

    NetworkState(Network network, ModuleArbitration arbitration) {
        this.network = network;
        moduleUsage = new int[network.modules()];
        preferences = new double[network.modules()];
        ModuleArbitration complete = arbitration.of(network.layout);
        arbiter = complete.isPlain() ? null : new ModuleArbiter(network.layout, complete);
        steps = new double[network.isRoughThroughout && arbiter == null ? KEPT_STEPS : 1]
                [network.slots + network.remembered];
        activations = steps[0];
        prefersBySums = arbiter == null && network.prefersBySums;
    }

    /** The network that this is a state of. */
    public Network network() {
        return network;
    }

    /**
     * Makes one step.
     *
     * @param inputs one value per input; each passes through the function of its input neuron
     * @param random one {@code nextInt} is drawn to choose among the modules with the highest preference, also if there
     *     is only one
     * @return the chosen module
     * @throws IllegalArgumentException if the number of inputs is wrong
     * @throws IllegalStateException if modules are chosen by preference and no preference is a number
     */
    public int activate(double[] inputs, ResumableRandom random) {
        if (inputs.length != network.inputs) {
            throw new IllegalArgumentException(
                    "the network has " + network.inputs + " inputs, got " + inputs.length + " values");
        }
        remember();
        for (int i = 0; i < network.inputs; i++) {
            // The pending sum of an input is 0; adding it turns -0 into 0.
            activations[i] = function(i, 0.0 + inputs[i]);
        }
        return finish(random);
    }

    /**
     * Makes one step from the activations of the input neurons instead of their input values. It saves time where the
     * caller has the activations in a table, for example tanh of each value of a sensor that has few values. To get the
     * result of {@link #activate}, the caller passes f(value), where f is the function of the input neuron.
     *
     * @param inputActivations activation of input i at index {@code offset + i}
     * @return the chosen module, as for {@link #activate}
     * @throws IllegalArgumentException if there are not as many values from {@code offset} on as the network has inputs
     * @throws IllegalStateException as for {@link #activate}
     */
    public int activateFrom(double[] inputActivations, int offset, ResumableRandom random) {
        begin(inputActivations, offset);
        return finish(random);
    }

    /**
     * Makes one step of a multitask network in which {@code module} is the one to use; one {@code nextInt} is drawn
     * nevertheless.
     *
     * @return the chosen module: {@code module} itself, unless the state's {@link ModuleArbitration} reads {@code
     *     module} as the number of a task, or changes preferences
     * @throws IllegalArgumentException as for {@link #presetModule} and {@link #activate}
     * @throws IllegalStateException as for {@link #activate}
     */
    public int activateWithModule(double[] inputs, int module, ResumableRandom random) {
        presetModule(module);
        return activate(inputs, random);
    }

    /**
     * Sets the choice of the task for the following steps; 0 at first. Its meaning depends on the network:
     *
     * <ul>
     *   <li>A multitask network ({@link mmneat.neat.ModuleLayout#multitask}): the number of the module that answers.
     *   <li>A network with groups of modules ({@link mmneat.neat.ModuleLayout#grouped}), or a state with {@link
     *       ModuleArbitration#withTasks}: the number of the group or task. Of its modules, preference chooses one.
     *   <li>All other networks ignore it.
     * </ul>
     *
     * @param module number of the module, group or task
     * @throws IllegalArgumentException if it is negative, or a multitask network has no such module, or none serves
     *     that task
     */
    public void presetModule(int module) {
        if (module < 0 || network.layout.standardMultitask() && module >= network.modules()) {
            throw new IllegalArgumentException(
                    "module must be one of the network's " + network.modules() + ", is " + module);
        }
        if (arbiter != null) {
            arbiter.requireTask(module);
        }
        presetModule = module;
    }

    /**
     * Forgets all steps: pending sums and activations become 0, fatigue too. The counts of module use, the preset
     * module and the last module stay.
     */
    public void flush() {
        if (!flushed) {
            Arrays.fill(activations, 0);
            step = -1;
            firstRough = 0;
            if (arbiter != null) {
                arbiter.flush();
            }
            flushed = true;
        }
    }

    /** Becomes as new: {@link #flush}, and counts, preset and last module 0. */
    public void reset() {
        flush();
        Arrays.fill(moduleUsage, 0);
        presetModule = 0;
        lastModule = 0;
    }

    /**
     * The answer of the last step: activation of a policy neuron of the chosen module; 0 after a flush.
     *
     * @param neuron number of the policy neuron within its module
     * @throws IllegalArgumentException if modules have no such policy neuron
     */
    public double policyOutput(int neuron) {
        if (arbiter != null && arbiter.averages()) {
            return arbiter.average(this, neuron);
        }
        return moduleOutput(lastModule, neuron);
    }

    /**
     * Activation of a module's policy neuron in the last step, whichever module was chosen; 0 after a flush.
     *
     * @throws IllegalArgumentException if there is no such module, or it has no such policy neuron
     */
    public double moduleOutput(int module, int neuron) {
        return activationOfOutput(network.layout.policyOutput(module, neuron));
    }

    /**
     * Activation of a module's preference neuron in the last step; 0 after a flush.
     *
     * @throws IllegalArgumentException if there is no such module, or the network has no preference neurons
     */
    public double preference(int module) {
        return activationOfOutput(network.layout.preferenceOutput(module));
    }

    /**
     * Activation of an output neuron, by output number, in the last step; 0 after a flush.
     *
     * @throws IllegalArgumentException if there is no such output
     */
    public double outputActivation(int output) {
        if (output < 0 || output >= network.slotOfOutput.length) {
            throw new IllegalArgumentException(
                    "output must be one of the network's " + network.slotOfOutput.length + ", is " + output);
        }
        return activationOfOutput(output);
    }

    private double activationOfOutput(int output) {
        if (flushed) {
            return 0;
        }
        computeExactly(network.groupOfOutput[output]);
        int slot = network.slotOfOutput[output];
        return isLazy(slot) ? function(slot, sum(slot)) : activations[slot];
    }

    /**
     * Activation of a node in the last step; 0 after a flush.
     *
     * @param position of the node in the genotype's list
     * @throws IllegalArgumentException if there is no such node, or it was left out ({@link Network#hasNode})
     */
    public double nodeActivation(int position) {
        if (!network.hasNode(position)) {
            throw new IllegalArgumentException(
                    "node " + position + " has no path to an output and was left out; compileWithAllNodes keeps it");
        }
        int slot = network.slotOfNode[position];
        if (isLazy(slot)) {
            return activationOfOutput(position - network.firstOutput());
        }
        for (int group = 0; group < network.groupStart.length - 1 && !flushed; group++) {
            computeExactly(group);
        }
        return activations[slot];
    }

    /** The module that was chosen in the last step; 0 before the first. */
    public int lastModule() {
        return lastModule;
    }

    /** How often each module was chosen since the state was made or reset (a copy). */
    public int[] moduleUsage() {
        return moduleUsage.clone();
    }

    /** First part of a step: what recurrent links and inputs bring. */
    void begin(double[] inputActivations, int offset) {
        if (offset < 0 || offset > inputActivations.length - network.inputs) {
            throw tooFew(inputActivations.length, offset);
        }
        remember();
        System.arraycopy(inputActivations, offset, activations, 0, network.inputs);
    }

    private IllegalArgumentException tooFew(int values, int offset) {
        return new IllegalArgumentException(
                "the network has " + network.inputs + " inputs, got " + values + " values to be read from " + offset);
    }

    /** Computes the exact activations of a group, and of those that it depends on. */
    void computeExactly(int group) {
        if ((exact & bit(group)) == 0) {
            if (group == Network.ALWAYS) {
                computeKeptStepsExactly();
            } else {
                computeExactly(group == Network.SHARED ? Network.ALWAYS : Network.SHARED);
                propagate(group);
            }
            setExact(group);
        }
    }

    private void computeKeptStepsExactly() {
        for (int i = firstRough; i <= step; i++) {
            activations = steps[i];
            if (i > firstRough) {
                recall(steps[i - 1]);
            }
            propagate(Network.ALWAYS);
        }
        firstRough = step + 1;
    }

    /** Computes a group roughly for this state and another, as far as they do not have it. */
    private void computeRoughly(NetworkState other, int group) {
        boolean needed = (computed & bit(group)) == 0;
        boolean otherNeeded = (other.computed & bit(group)) == 0;
        if (needed || otherNeeded) {
            if (group > Network.SHARED) {
                computeRoughly(other, Network.SHARED);
            }
            // Values that are there may be exact, and are not written again.
            double[] a = (needed ? this : other).activations;
            double[] b = (otherNeeded ? other : this).activations;
            Propagation.roughly(network, a, b, network.groupStart[group], network.groupStart[group + 1]);
            computed |= bit(group);
            other.computed |= bit(group);
        }
    }

    /**
     * Second part of a step: computes what later steps need, and preferences as far as sums tell them.
     *
     * @param other a state that makes the same part of its step side by side; this one if there is none
     */
    void computeWith(NetworkState other) {
        if (steps.length > 1) {
            computeRoughly(other, Network.ALWAYS);
        } else if (other == this || network.functions != null) {
            computeExactly(Network.ALWAYS);
            other.computeExactly(Network.ALWAYS);
        } else {
            Propagation.exactly(
                    network, activations, other.activations, network.inputs, network.groupStart[Network.ALWAYS + 1]);
            setExact(Network.ALWAYS);
            other.setExact(Network.ALWAYS);
        }
        if (prefersBySums) {
            computeRoughly(other, Network.SHARED);
            for (int module = 0; module < preferences.length; module++) {
                int slot = network.slotOfPreference[module];
                Propagation.sums(
                        network, activations, other.activations, slot, preferences, module, other.preferences, module);
            }
        }
    }

    private int finish(ResumableRandom random) {
        computeExactly(Network.SHARED);
        computeWith(this);
        return chooseModule(random);
    }

    private void propagate(int group) {
        int from = network.groupStart[group];
        int to = network.groupStart[group + 1];
        if (network.functions == null) {
            Propagation.exactly(network, activations, from, to);
        } else {
            for (int slot = from; slot < to; slot++) {
                activations[slot] = function(slot, sum(slot));
            }
        }
    }

    /** The bit of a group; groups beyond 63 have none and are computed again whenever they are needed. */
    private static long bit(int group) {
        return group < Long.SIZE ? 1L << group : 0;
    }

    private void setExact(int group) {
        exact |= bit(group);
        computed |= bit(group);
    }

    private boolean isLazy(int slot) {
        return slot >= network.firstLazy;
    }

    /** Goes on to the next step, with what recurrent links read of the present one. */
    private void remember() {
        if (step == steps.length - 1) {
            computeExactly(Network.ALWAYS);
            firstRough = step + 1;
        }
        if (firstRough > step) {
            step = -1;
            firstRough = 0;
        }
        double[] before = activations;
        activations = steps[++step];
        recall(before);
        flushed = false;
        exact = 0;
        computed = 0;
    }

    /** Copies what recurrent links read from the activations of the step before. */
    private void recall(double[] before) {
        System.arraycopy(before, network.inputs, activations, network.slots, network.remembered);
    }

    private double sum(int slot) {
        return Propagation.sum(network, activations, slot);
    }

    private double function(int slot, double sum) {
        return network.functions == null ? Tanh.of(sum) : Functions.of(network.functions[slot], sum);
    }

    /** Last part of a step, after at least what later steps need. */
    int chooseModule(ResumableRandom random) {
        lastModule = arbiter != null ? arbiter.choose(this, presetModule, random) : preferredModule(random);
        moduleUsage[lastModule]++;
        return lastModule;
    }

    private int preferredModule(ResumableRandom random) {
        if (network.modules() == 1 || network.layout.standardMultitask()) {
            random.nextInt(1);
            return network.layout.standardMultitask() ? presetModule : 0;
        }
        int clear = prefersBySums ? HighestSum.of(preferences, preferences.length, network.margin) : HighestSum.UNCLEAR;
        if (clear != HighestSum.UNCLEAR) {
            random.nextInt(1);
            return clear;
        }
        for (int module = 0; module < preferences.length; module++) {
            preferences[module] = preference(module);
        }
        return Argmax.of(preferences, random);
    }

    /**
     * Computes the sums of a policy neuron of the chosen module, up to the network's margin, for this state and another
     * that chose the same module. Modules are chosen and answer plainly.
     *
     * @param sums receives this state's sum at {@code i} and the other's at {@code j}
     */
    void sumAnswersRoughly(NetworkState other, int neuron, double[] sums, int i, int j) {
        int output = network.layout.policyOutput(lastModule, neuron);
        computeRoughly(other, network.groupOfOutput[output]);
        Propagation.sums(network, activations, other.activations, network.slotOfOutput[output], sums, i, sums, j);
    }

    /** Whether the answer can be told from a sum: a chosen module's neuron, its function tanh. */
    boolean answersBySum() {
        return network.functions == null && (arbiter == null || !arbiter.averages());
    }
}
