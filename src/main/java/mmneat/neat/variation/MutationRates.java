package mmneat.neat.variation;

import java.util.Objects;

/**
 * Rates of the mutations of an offspring, each a probability in [0, 1]. The names in brackets are the parameters of the
 * command line that set them.
 *
 * <p>Source: Schrum and Miikkulainen 2016, section 5.2.3; docs/specification/networks.md, sections 1 and 8.1.
 *
 * @param newLink a new link is tried ({@code netLinkRate})
 * @param spliceNeuron a neuron is spliced into a link ({@code netSpliceRate})
 * @param perLinkWeight each weight is changed ({@code perLinkMutateRate})
 * @param oneWeight a single weight is changed; only if {@code perLinkWeight} is 0 ({@code netPerturbRate})
 * @param module rates of the mutations that add a module
 * @param deletion rates of the mutations that remove something
 * @param freezing rates of the mutations that freeze a part of the network
 */
public record MutationRates(
        double newLink,
        double spliceNeuron,
        double perLinkWeight,
        double oneWeight,
        ModuleRates module,
        DeletionRates deletion,
        FreezingRates freezing) {

    /** The rates of the published experiments without module mutation. */
    public static final MutationRates PUBLISHED =
            new MutationRates(0.4, 0.2, 0.05, 0.8, ModuleRates.NONE, DeletionRates.NONE, FreezingRates.NONE);

    /**
     * Checked rates.
     *
     * @throws IllegalArgumentException if a rate is not in [0, 1]
     * @throws NullPointerException if the rates of a kind are missing; the message names them
     */
    public MutationRates {
        requireProbability("newLink", newLink);
        requireProbability("spliceNeuron", spliceNeuron);
        requireProbability("perLinkWeight", perLinkWeight);
        requireProbability("oneWeight", oneWeight);
        Objects.requireNonNull(module, "module");
        Objects.requireNonNull(deletion, "deletion");
        Objects.requireNonNull(freezing, "freezing");
    }

    /**
     * These rates with module duplication, MM(D), at a rate.
     *
     * @throws IllegalArgumentException if the rate is not in [0, 1]
     */
    public MutationRates withModuleDuplication(double rate) {
        ModuleRates modules = new ModuleRates(module.previous(), module.random(), rate, module.full());
        return new MutationRates(newLink, spliceNeuron, perLinkWeight, oneWeight, modules, deletion, freezing);
    }

    private static void requireProbability(String name, double value) {
        if (!(value >= 0 && value <= 1)) {
            throw new IllegalArgumentException(name + " must be in [0, 1], is " + value);
        }
    }

    /**
     * Rates of the mutations that add a module.
     *
     * @param previous MM(P): linked to the last module ({@code mmpRate})
     * @param random MM(R): random links ({@code mmrRate})
     * @param duplication MM(D): copy of a random module ({@code mmdRate})
     * @param full linked to all inputs ({@code fullMMRate})
     */
    public record ModuleRates(double previous, double random, double duplication, double full) {

        /** No module is added. */
        public static final ModuleRates NONE = new ModuleRates(0, 0, 0, 0);

        /**
         * Checked rates.
         *
         * @throws IllegalArgumentException if a rate is not in [0, 1]
         */
        public ModuleRates {
            requireProbability("module.previous", previous);
            requireProbability("module.random", random);
            requireProbability("module.duplication", duplication);
            requireProbability("module.full", full);
        }

        /** Whether modules can be added, so that networks need preference neurons from the start. */
        public boolean canAddModules() {
            return previous > 0 || random > 0 || duplication > 0 || full > 0;
        }
    }

    /**
     * Rates of the mutations that remove something.
     *
     * @param link a random link ({@code deleteLinkRate})
     * @param module a module; only networks with several modules lose one ({@code deleteModeRate})
     */
    public record DeletionRates(double link, double module) {

        /** Nothing is removed. */
        public static final DeletionRates NONE = new DeletionRates(0, 0);

        /**
         * Checked rates.
         *
         * @throws IllegalArgumentException if a rate is not in [0, 1]
         */
        public DeletionRates {
            requireProbability("deletion.link", link);
            requireProbability("deletion.module", module);
        }
    }

    /**
     * Rates of the mutations that freeze a part of the network.
     *
     * @param policy policy neurons and everything upstream of them ({@code freezePolicyRate})
     * @param preference preference neurons and everything upstream of them ({@code freezePreferenceRate})
     * @param alternate the preference neurons if the policy neurons are frozen, otherwise (also if nothing is frozen)
     *     the policy neurons, with everything upstream ({@code freezeAlternateRate})
     */
    public record FreezingRates(double policy, double preference, double alternate) {

        /** Nothing is frozen. */
        public static final FreezingRates NONE = new FreezingRates(0, 0, 0);

        /**
         * Checked rates.
         *
         * @throws IllegalArgumentException if a rate is not in [0, 1]
         */
        public FreezingRates {
            requireProbability("freezing.policy", policy);
            requireProbability("freezing.preference", preference);
            requireProbability("freezing.alternate", alternate);
        }
    }
}
