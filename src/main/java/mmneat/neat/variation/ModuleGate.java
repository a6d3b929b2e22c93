package mmneat.neat.variation;

/**
 * The rule that decides whether an offspring may gain a module: every module of its parent must have been used enough.
 *
 * <p>Source: docs/specification/networks.md, section 8.6.
 *
 * @param maxModules no module is added to a network that has this number of modules ({@code maxModes})
 * @param usageForNewModule the least used of n modules must have been chosen in at least 1 / (this * n) of the steps
 *     ({@code usageForNewMode}); with 0 no module is ever added
 */
public record ModuleGate(int maxModules, double usageForNewModule) {

    /** The gate of the published experiments. */
    public static final ModuleGate PUBLISHED = new ModuleGate(1000, 10);

    /**
     * A checked gate.
     *
     * @throws IllegalArgumentException if {@code maxModules} is less than 1 or {@code usageForNewModule} less than 0
     */
    public ModuleGate {
        if (maxModules < 1) {
            throw new IllegalArgumentException("maxModules must be at least 1, is " + maxModules);
        }
        if (!(usageForNewModule >= 0)) {
            throw new IllegalArgumentException("usageForNewModule must be at least 0, is " + usageForNewModule);
        }
        // With minus zero the required share would be minus infinity: every usage would be enough instead of none.
        usageForNewModule = Math.abs(usageForNewModule);
    }

    /**
     * Whether a network may gain a module.
     *
     * @param modules modules of the network
     * @param usage how often each was chosen in the last evaluation; if all counts are 0, no module may be added
     */
    public boolean isOpen(int modules, int[] usage) {
        if (modules >= maxModules) {
            return false;
        }
        return usage.length != modules || leastShare(usage) >= 1.0 / (usageForNewModule * modules);
    }

    private static double leastShare(int[] usage) {
        double sum = 0;
        int least = Integer.MAX_VALUE;
        for (int count : usage) {
            sum += count;
            least = Math.min(least, count);
        }
        return sum == 0 ? 0 : least / sum;
    }
}
