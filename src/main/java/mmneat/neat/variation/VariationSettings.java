package mmneat.neat.variation;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import mmneat.neat.ActivationFunction;

/**
 * The settings of mutation and crossover.
 *
 * @param rates mutation rates
 * @param gate when a module may be added
 * @param crossoverExcessRate probability that a crossover gives both children all genes that only one parent has, in
 *     [0, 1] ({@code crossExcessRate})
 * @param isLeastUsedModuleDeleted whether module deletion takes the least used module, else a random one ({@code
 *     deleteLeastUsed})
 * @param selection inputs that a new module is linked to
 * @param activation activation function of new neurons
 * @param ownMutations additional mutation operators of the caller, tried in this order after all others; usually none
 * @param ownCrossover crossover of the caller instead of NEAT's; usually none
 */
public record VariationSettings(
        MutationRates rates,
        ModuleGate gate,
        double crossoverExcessRate,
        boolean isLeastUsedModuleDeleted,
        InputSelection selection,
        ActivationFunction activation,
        List<OwnMutation> ownMutations,
        Optional<CrossoverOperator> ownCrossover) {

    /**
     * An additional mutation operator of the caller.
     *
     * @param rate probability that it is tried on an offspring, in [0, 1]
     * @param operator the operator
     */
    public record OwnMutation(double rate, MutationOperator operator) {

        /**
         * A checked operator.
         *
         * @throws IllegalArgumentException if {@code rate} is not in [0, 1]
         * @throws NullPointerException if the operator is missing
         */
        public OwnMutation {
            Objects.requireNonNull(operator, "operator");
            if (!(rate >= 0 && rate <= 1)) {
                throw new IllegalArgumentException(
                        "rate of the mutation '" + operator.logName() + "' must be in [0, 1], is " + rate);
            }
        }
    }

    /**
     * Checked settings.
     *
     * @throws IllegalArgumentException if {@code crossoverExcessRate} is not in [0, 1]
     * @throws NullPointerException if a part is missing; the message names it
     */
    public VariationSettings {
        Objects.requireNonNull(rates, "rates");
        Objects.requireNonNull(gate, "gate");
        Objects.requireNonNull(selection, "selection");
        Objects.requireNonNull(activation, "activation");
        Objects.requireNonNull(ownCrossover, "ownCrossover");
        ownMutations = List.copyOf(Objects.requireNonNull(ownMutations, "ownMutations"));
        if (!(crossoverExcessRate >= 0 && crossoverExcessRate <= 1)) {
            throw new IllegalArgumentException("crossoverExcessRate must be in [0, 1], is " + crossoverExcessRate);
        }
    }

    /** Settings without operators of the caller. */
    public VariationSettings(
            MutationRates rates,
            ModuleGate gate,
            double crossoverExcessRate,
            boolean isLeastUsedModuleDeleted,
            InputSelection selection,
            ActivationFunction activation) {
        this(
                rates,
                gate,
                crossoverExcessRate,
                isLeastUsedModuleDeleted,
                selection,
                activation,
                List.of(),
                Optional.empty());
    }

    /** The settings of the published experiments, with other mutation rates. */
    public VariationSettings(MutationRates rates) {
        this(rates, ModuleGate.PUBLISHED, 0, false, InputSelection.ALL, ActivationFunction.TANH);
    }

    /** These settings with other mutation rates. */
    public VariationSettings withRates(MutationRates newRates) {
        return new VariationSettings(
                newRates,
                gate,
                crossoverExcessRate,
                isLeastUsedModuleDeleted,
                selection,
                activation,
                ownMutations,
                ownCrossover);
    }

    /** These settings with another activation function of new neurons. */
    public VariationSettings withActivation(ActivationFunction function) {
        return new VariationSettings(
                rates,
                gate,
                crossoverExcessRate,
                isLeastUsedModuleDeleted,
                selection,
                function,
                ownMutations,
                ownCrossover);
    }

    /**
     * Returns these settings with one more mutation operator, which is tried last.
     *
     * @throws IllegalArgumentException if the rate is not in [0, 1]
     */
    public VariationSettings withMutation(double rate, MutationOperator operator) {
        List<OwnMutation> more = new ArrayList<>(ownMutations);
        more.add(new OwnMutation(rate, operator));
        return new VariationSettings(
                rates, gate, crossoverExcessRate, isLeastUsedModuleDeleted, selection, activation, more, ownCrossover);
    }

    /** These settings with a crossover of the caller's own. */
    public VariationSettings withCrossover(CrossoverOperator crossover) {
        return new VariationSettings(
                rates,
                gate,
                crossoverExcessRate,
                isLeastUsedModuleDeleted,
                selection,
                activation,
                ownMutations,
                Optional.of(crossover));
    }
}
