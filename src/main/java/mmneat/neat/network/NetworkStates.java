package mmneat.neat.network;

import mmneat.random.ResumableRandom;

/**
 * A few states of one network that are activated together, such as one per direction of movement: the same as one after
 * the other, but faster ({@link Propagation}).
 *
 * <p>Belongs to one thread. Stepping allocates nothing.
 */
public final class NetworkStates {

    /** As many as a bit mask of an int can name. */
    private static final int MOST = 31;

    private final Network network;
    private final NetworkState[] states;
    /** The states of the present step, in order. */
    private final NetworkState[] active;
    /** Sums of answers that are compared. */
    private final double[] answers;

    NetworkStates(Network network, int count, ModuleArbitration arbitration) {
        if (count < 1 || count > MOST) {
            throw new IllegalArgumentException("number of states must be 1 to " + MOST + ", is " + count);
        }
        this.network = network;
        states = new NetworkState[count];
        active = new NetworkState[count];
        answers = new double[count];
        for (int i = 0; i < count; i++) {
            states[i] = new NetworkState(network, arbitration);
        }
    }

    /** Number of states. */
    public int size() {
        return states.length;
    }

    /**
     * One of the states; it may be used by itself too.
     *
     * @throws IndexOutOfBoundsException if there is no such state
     */
    public NetworkState get(int index) {
        return states[index];
    }

    /**
     * Makes one step in some states, each with its own inputs; exactly as {@link NetworkState#activateFrom} of one
     * after the other by index. States that are not asked for stay as they are.
     *
     * @param which bit i is set if state i makes a step; a state's chosen module and answer are then read from it
     * @param inputActivations activation of input j of state i at index {@code i * stride + j}
     * @param stride distance between the rows of two states, at least the number of inputs
     * @param random one {@code nextInt} is drawn per state that makes a step, by index
     * @throws IllegalArgumentException if a bit is set for which there is no state or not a whole row of values, or the
     *     stride is less than the number of inputs
     * @throws IllegalStateException as for {@link NetworkState#activate}
     */
    public void activate(int which, double[] inputActivations, int stride, ResumableRandom random) {
        requireStates(which);
        if (stride < network.inputs) {
            throw new IllegalArgumentException(
                    "stride must be at least the network's " + network.inputs + " inputs, is " + stride);
        }
        int count = 0;
        for (int i = 0; i < states.length; i++) {
            if ((which >>> i & 1) != 0) {
                states[i].begin(inputActivations, i * stride);
                active[count++] = states[i];
            }
        }
        for (int i = 0; i < count; i++) {
            if (i % 2 == 0) {
                active[i].computeWith(active[Math.min(i + 1, count - 1)]);
            }
            active[i].chooseModule(random);
        }
    }

    private void requireStates(int which) {
        if (which >>> states.length != 0) {
            throw new IllegalArgumentException("the bits " + Integer.toBinaryString(which)
                    + " name a state that does not exist; there are " + states.length + " states");
        }
    }

    /**
     * Returns the state with the highest answer of the last step, if an approximation within a proven error bound is
     * enough to find it. If this returns -1, compare the {@link NetworkState#policyOutput} of the states; it is always
     * exact, after this call too. A highest answer that may be as low as -1 is not decided here, because callers
     * compare it with the constant -1 of directions without a state.
     *
     * @param which the same as in the last step
     * @param neuron number of the policy neuron that answers
     * @return the state whose {@link NetworkState#policyOutput} is higher than those of all others and higher than -1;
     *     the number -1 if the approximation cannot decide it
     * @throws IllegalArgumentException if a bit is set for which there is no state, or modules have no such policy
     *     neuron
     */
    public int clearlyHighest(int which, int neuron) {
        requireStates(which);
        int count = 0;
        for (int i = 0; i < states.length; i++) {
            if ((which >>> i & 1) != 0) {
                active[count++] = states[i];
            }
        }
        if (count == 0 || !active[0].answersBySum()) {
            return HighestSum.UNCLEAR;
        }
        int highest = clearlyHighestSum(count, neuron);
        return highest == HighestSum.UNCLEAR ? highest : indexOf(active[highest]);
    }

    private int clearlyHighestSum(int count, int neuron) {
        for (int i = 0, last; i < count; i = last + 1) {
            last = i + 1 < count && active[i + 1].lastModule() == active[i].lastModule() ? i + 1 : i;
            active[i].sumAnswersRoughly(active[last], neuron, answers, i, last);
        }
        return HighestSum.of(answers, count, network.margin);
    }

    private int indexOf(NetworkState state) {
        int index = 0;
        while (states[index] != state) {
            index++;
        }
        return index;
    }

    /**
     * Calls {@link NetworkState#presetModule} of every state.
     *
     * @throws IllegalArgumentException as {@link NetworkState#presetModule}
     */
    public void presetModule(int module) {
        for (NetworkState state : states) {
            state.presetModule(module);
        }
    }

    /** {@link NetworkState#flush} of every state. */
    public void flush() {
        for (NetworkState state : states) {
            state.flush();
        }
    }

    /** {@link NetworkState#reset} of every state. */
    public void reset() {
        for (NetworkState state : states) {
            state.reset();
        }
    }
}
