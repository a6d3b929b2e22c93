package mmneat.neat.network;

import java.util.Arrays;

/**
 * Puts neurons into an order that has sources before targets and in which as many as possible come in fours that do not depend on
 * each other: a list schedule, in which the neuron with the longest path of forward links from it comes first. Used once; time
 * is linear in nodes and links, apart from looking for the next path length.
 *
 * <p>Links are given by target: those into node n are {@code [incomingStart[n], incomingStart[n + 1])}, their sources ascending.
 * Sources at or behind the target are recurrent and do not count.
 */
final class Fours {

    private static final int NONE = -1;

    private final int[] incomingStart;
    private final int[] incomingSource;
    private final boolean[] belongs;

    /** Per neuron: number of links of the longest path from it. */
    private final int[] height;
    /** Per neuron: number of its sources that are not in the order yet. */
    private final int[] missingSources;

    /** The links the other way round: targets of node n are {@code [outgoingStart[n], outgoingStart[n + 1])}. */
    private final int[] outgoingStart;

    private final int[] outgoingTarget;

    /** The neurons whose sources are in the order, as a list per height: the first of each list, and the next of each neuron. */
    private final int[] firstReady;

    private final int[] nextReady;
    /** The highest list that is not empty; {@link #NONE} if all are. */
    private int highest = NONE;

    private final int[] order;
    private int complete;

    /**
     * Finds the order.
     *
     * @param belongs per node, whether it is one of the neurons
     */
    Fours(int[] incomingStart, int[] incomingSource, boolean[] belongs) {
        this.incomingStart = incomingStart;
        this.incomingSource = incomingSource;
        this.belongs = belongs;
        int nodes = belongs.length;
        height = new int[nodes];
        missingSources = new int[nodes];
        outgoingStart = new int[nodes + 1];
        order = new int[measurePaths()];
        outgoingTarget = new int[outgoingStart[nodes]];
        gatherTargets();
        firstReady = new int[1 + Arrays.stream(height).max().orElse(0)];
        Arrays.fill(firstReady, NONE);
        nextReady = new int[nodes];
        schedule();
    }

    /** The neurons, sources before targets. */
    int[] order() {
        return order;
    }

    /** How many of them, from the first on, come in fours. */
    int complete() {
        return complete;
    }

    /** Finds the heights, counts sources and where targets will start, and returns the number of neurons. */
    private int measurePaths() {
        int neurons = 0;
        for (int target = belongs.length - 1; target >= 0; target--) {
            neurons += belongs[target] ? 1 : 0;
            for (int link = incomingStart[target]; counts(link, target); link++) {
                int source = incomingSource[link];
                if (belongs[source]) {
                    height[source] = Math.max(height[source], height[target] + 1);
                    missingSources[target]++;
                    outgoingStart[source + 1]++;
                }
            }
        }
        for (int i = 0; i < belongs.length; i++) {
            outgoingStart[i + 1] += outgoingStart[i];
        }
        return neurons;
    }

    private void gatherTargets() {
        int[] next = Arrays.copyOf(outgoingStart, belongs.length);
        for (int target = 0; target < belongs.length; target++) {
            for (int link = incomingStart[target]; counts(link, target); link++) {
                int source = incomingSource[link];
                if (belongs[source]) {
                    outgoingTarget[next[source]++] = target;
                }
            }
        }
    }

    /** Whether this is one of the forward links into the target, which belongs. */
    private boolean counts(int link, int target) {
        return belongs[target] && link < incomingStart[target + 1] && incomingSource[link] < target;
    }

    private void schedule() {
        for (int i = belongs.length - 1; i >= 0; i--) {
            if (belongs[i] && missingSources[i] == 0) {
                addReady(i);
            }
        }
        int done = 0;
        while (done < order.length) {
            int start = done;
            while (done < start + Propagation.FOUR && highest != NONE) {
                order[done++] = takeReady();
            }
            if (done == start + Propagation.FOUR && complete == start) {
                complete = done;
            }
            for (int i = start; i < done; i++) {
                tellTargets(order[i]);
            }
        }
    }

    private void tellTargets(int source) {
        for (int i = outgoingStart[source]; i < outgoingStart[source + 1]; i++) {
            int target = outgoingTarget[i];
            missingSources[target]--;
            if (missingSources[target] == 0) {
                addReady(target);
            }
        }
    }

    private void addReady(int neuron) {
        nextReady[neuron] = firstReady[height[neuron]];
        firstReady[height[neuron]] = neuron;
        highest = Math.max(highest, height[neuron]);
    }

    private int takeReady() {
        int neuron = firstReady[highest];
        firstReady[highest] = nextReady[neuron];
        while (highest != NONE && firstReady[highest] == NONE) {
            highest--;
        }
        return neuron;
    }
}
