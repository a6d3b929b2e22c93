package mmneat.mspacman;

import java.util.Arrays;

/**
 * Counts of how often output modules were used in a game, in all time steps and in those of a certain situation: a
 * ghost is edible or none is, Ms.&nbsp;Pac-Man is at a junction or anywhere.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 9; the paper's figures of module use count the module of the
 * chosen direction.
 */
public final class ModuleUse {

    /** The set of time steps over which module use is summed. */
    public enum When {
        /** All time steps. */
        ALL,
        /** Time steps in which Ms.&nbsp;Pac-Man is at a junction. */
        AT_JUNCTION,
        /** Time steps in which at least one ghost is edible. */
        EDIBLE,
        /** Time steps in which no ghost is edible. */
        THREAT,
        /** Time steps at a junction in which at least one ghost is edible. */
        EDIBLE_AT_JUNCTION,
        /** Time steps at a junction in which no ghost is edible. */
        THREAT_AT_JUNCTION
    }

    private static final int DIRECTIONS = 4;
    private static final int EDIBLE_BIT = 1;
    private static final int JUNCTION_BIT = 2;

    /** Index of the counter of the chosen direction, after those of the four networks. */
    private static final int CHOSEN = DIRECTIONS;

    private final int modules;

    /** Uses of module m in observation s (two bits) by network n, at index (4 n + s) modules + m. */
    private final int[] counts;

    private int decisions;

    /** Creates counts of 0. */
    public ModuleUse(int modules) {
        this.modules = modules;
        counts = new int[(DIRECTIONS + 1) * 4 * modules];
    }

    static int observation(boolean edible, boolean atJunction) {
        return (edible ? EDIBLE_BIT : 0) | (atJunction ? JUNCTION_BIT : 0);
    }

    /** Counts a use of a module by the network of a direction. */
    void countNetwork(int direction, int observation, int module) {
        counts[(4 * direction + observation) * modules + module]++;
    }

    /** Counts a decision for a direction whose network last used this module. */
    void countDecision(int observation, int module) {
        decisions++;
        counts[(4 * CHOSEN + observation) * modules + module]++;
    }

    void clear() {
        decisions = 0;
        Arrays.fill(counts, 0);
    }

    /** Adds the counts of another object with the same number of modules. */
    public void add(ModuleUse other) {
        decisions += other.decisions;
        for (int i = 0; i < counts.length; i++) {
            counts[i] += other.counts[i];
        }
    }

    /** Returns an independent copy. */
    public ModuleUse copy() {
        ModuleUse copy = new ModuleUse(modules);
        copy.add(this);
        return copy;
    }

    /** Number of decisions: time steps in which a direction was chosen. */
    public int decisions() {
        return decisions;
    }

    /** How often the network of the chosen direction used each module. */
    public int[] ofChosenDirection(When when) {
        return sum(CHOSEN, when);
    }

    /** How often the network of a direction, 0 to 3, used each module. */
    public int[] ofNetwork(int direction, When when) {
        return sum(direction, when);
    }

    private int[] sum(int network, When when) {
        int[] sum = new int[modules];
        for (int observation = 0; observation < 4; observation++) {
            boolean edible = (observation & EDIBLE_BIT) != 0;
            boolean atJunction = (observation & JUNCTION_BIT) != 0;
            boolean counts =
                    switch (when) {
                        case ALL -> true;
                        case AT_JUNCTION -> atJunction;
                        case EDIBLE -> edible;
                        case THREAT -> !edible;
                        case EDIBLE_AT_JUNCTION -> edible && atJunction;
                        case THREAT_AT_JUNCTION -> !edible && atJunction;
                    };
            for (int module = 0; module < modules && counts; module++) {
                sum[module] += this.counts[(4 * network + observation) * modules + module];
            }
        }
        return sum;
    }
}
