package mmneat.neat.network;

import java.util.Arrays;
import mmneat.neat.ActivationFunction;
import mmneat.random.ResumableRandom;

/**
 * One place where a network is used: what it remembers from step to step, and how often it chose each module.
 *
 * <p>Any number of states may share one {@link Network}; a state belongs to one thread. After a step, and until the next
 * step or flush, every activation can be read. Stepping allocates nothing.
 *
 * <p>Source: spec/networks.md, sections 5.2 and 6.
 */
public final class NetworkState {

    /** Sums that are further apart, and not both beyond {@link #STEEP} on one side, have different tanh. */
    private static final double CLEAR_DIFFERENCE = 1e-9;

    private static final double STEEP = 5;

    private final Network network;
    /** Activation of each slot that is not lazy. */
    final double[] activations;
    /** What recurrent links bring to each slot in this step, from the activations of the previous one. */
    final double[] carried;

    private final int[] moduleUsage;
    /** Sum or activation of each preference neuron while the module is chosen. */
    private final double[] preferences;
    /** How modules are chosen if not by plain preference, else null. */
    private final ModuleArbiter arbiter;

    private int presetModule;
    private int lastModule;
    /** Whether no step has been made since everything was set to 0. */
    private boolean flushed = true;

    NetworkState(Network network, ModuleArbitration arbitration) {
        this.network = network;
        activations = new double[network.slots];
        carried = new double[network.slots];
        moduleUsage = new int[network.modules()];
        preferences = new double[network.modules()];
        arbiter = arbitration.isPlain() ? null : new ModuleArbiter(network.layout, arbitration);
    }

    /** The network that this is a state of. */
    public Network network() {
        return network;
    }

    /**
     * Makes one step.
     *
     * @param inputs one value per input; each passes through the function of its input neuron
     * @param random one {@code nextInt} is drawn to choose among the modules with the highest preference, also if there is
     *     only one
     * @return the chosen module
     * @throws IllegalArgumentException if the number of inputs is wrong
     */
    public int activate(double[] inputs, ResumableRandom random) {
        if (inputs.length != network.inputs) {
            throw new IllegalArgumentException(
                    "the network has " + network.inputs + " inputs, got " + inputs.length + " values");
        }
        carry();
        for (int i = 0; i < network.inputs; i++) {
            // The pending sum of an input is 0; adding it turns -0 into 0.
            activations[i] = function(i, 0.0 + inputs[i]);
        }
        propagate();
        return chooseModule(random);
    }

    /**
     * Makes one step from activations of input neurons that the caller knows already, as tanh of the few values that a
     * sensor can have.
     *
     * @param inputActivations activation of input i at index {@code offset + i}
     * @return the chosen module, as for {@link #activate}
     */
    public int activateFrom(double[] inputActivations, int offset, ResumableRandom random) {
        begin(inputActivations, offset);
        propagate();
        return chooseModule(random);
    }

    /**
     * Makes one step of a multitask network in which {@code module} is the one to use; one {@code nextInt} is drawn
     * nevertheless.
     *
     * @return {@code module}
     * @throws IllegalArgumentException if there is no such module
     */
    public int activateWithModule(double[] inputs, int module, ResumableRandom random) {
        presetModule(module);
        return activate(inputs, random);
    }

    /**
     * Names the module that a multitask network uses from now on (0 at first); with {@link ModuleArbitration#withTasks},
     * the task. Networks with preference neurons do not look at it otherwise.
     *
     * @throws IllegalArgumentException if it is negative, or a multitask network has no such module
     */
    public void presetModule(int module) {
        if (module < 0 || network.layout.standardMultitask() && module >= network.modules()) {
            throw new IllegalArgumentException(
                    "module must be one of the network's " + network.modules() + ", is " + module);
        }
        presetModule = module;
    }

    /**
     * Forgets all steps: pending sums and activations become 0, fatigue too. The counts of module use, the preset module
     * and the last module stay.
     */
    public void flush() {
        if (!flushed) {
            Arrays.fill(activations, 0);
            Arrays.fill(carried, 0);
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

    /** The answer of the last step: activation of a policy neuron of the chosen module; 0 after a flush. */
    public double policyOutput(int neuron) {
        if (arbiter != null && arbiter.averages()) {
            return arbiter.average(this, neuron);
        }
        return moduleOutput(lastModule, neuron);
    }

    /** Activation of a module's policy neuron in the last step, whichever module was chosen. */
    public double moduleOutput(int module, int neuron) {
        return outputActivation(network.layout.policyOutput(module, neuron));
    }

    /** Activation of a module's preference neuron in the last step; only in networks that have such neurons. */
    public double preference(int module) {
        return outputActivation(network.layout.preferenceOutput(module));
    }

    /** Activation of an output neuron, by output number, in the last step; 0 after a flush. */
    public double outputActivation(int output) {
        return slotActivation(network.slotOfOutput[output]);
    }

    /**
     * Activation of a node in the last step; 0 after a flush.
     *
     * @param position of the node in the genotype's list
     * @throws IllegalArgumentException if the node was left out ({@link Network#hasNode})
     */
    public double nodeActivation(int position) {
        int slot = network.slotOfNode[position];
        if (slot == Network.LEFT_OUT) {
            throw new IllegalArgumentException(
                    "node " + position + " reaches no output and was left out; compileWithAllNodes keeps it");
        }
        return slotActivation(slot);
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
        carry();
        System.arraycopy(inputActivations, offset, activations, 0, network.inputs);
    }

    /** Second part of a step: the activations of all neurons that are not lazy. */
    void propagate() {
        if (network.functions == null) {
            for (int slot = network.inputs; slot < network.firstLazy; slot++) {
                activations[slot] = Tanh.of(sum(slot));
            }
        } else {
            for (int slot = network.inputs; slot < network.firstLazy; slot++) {
                activations[slot] = function(slot, sum(slot));
            }
        }
    }

    /** Sums up what recurrent links bring, before the activations that they read are overwritten. */
    private void carry() {
        flushed = false;
        int[] targets = network.recurrentTarget;
        int[] start = network.recurrentStart;
        for (int i = 0; i < targets.length; i++) {
            double sum = 0;
            for (int link = start[i]; link < start[i + 1]; link++) {
                sum += activations[network.recurrentSource[link]] * network.recurrentWeight[link];
            }
            carried[targets[i]] = sum;
        }
    }

    private double sum(int slot) {
        double[] weight = network.forwardWeight;
        int[] source = network.forwardSource;
        double sum = carried[slot];
        int end = network.forwardStart[slot + 1];
        for (int link = network.forwardStart[slot]; link < end; link++) {
            sum += activations[source[link]] * weight[link];
        }
        return sum;
    }

    private double function(int slot, double sum) {
        ActivationFunction function = network.functions == null ? ActivationFunction.TANH : network.functions[slot];
        return Functions.of(function, sum);
    }

    private double slotActivation(int slot) {
        // What a lazy neuron reads stays as it was in the last step: nothing is computed after it.
        return slot < network.firstLazy ? activations[slot] : flushed ? 0 : function(slot, sum(slot));
    }

    /** Last part of a step. */
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
        int clear = network.functions == null ? clearlyPreferredModule() : -1;
        if (clear >= 0) {
            random.nextInt(1);
            return clear;
        }
        for (int module = 0; module < preferences.length; module++) {
            preferences[module] = preference(module);
        }
        return ModuleArbiter.highest(preferences, random);
    }

    /*
     * tanh rises, so the highest sum mostly tells the highest preference, and the tanh of preference neurons need not be
     * computed. Rounding could make two preferences equal or swap them only if the sums are close together or both far
     * out: for u > -5, l < 5 and u > l + 1e-9, tanh(u) - tanh(l) > 1e-9 (1 - tanh(5.1)^2) > 1e-13, which is some thousand
     * times the error of our tanh.
     */
    private int clearlyPreferredModule() {
        int best = 0;
        for (int module = 0; module < preferences.length; module++) {
            preferences[module] = sum(network.slotOfOutput[network.layout.preferenceOutput(module)]);
            best = preferences[module] > preferences[best] ? module : best;
        }
        double highest = preferences[best];
        for (int module = 0; module < preferences.length; module++) {
            double other = preferences[module];
            boolean clear = highest - other > CLEAR_DIFFERENCE && highest > -STEEP && other < STEEP;
            if (!clear && module != best) {
                return -1;
            }
        }
        return best;
    }
}
