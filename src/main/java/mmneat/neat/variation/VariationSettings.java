package mmneat.neat.variation;

import java.util.Objects;
import mmneat.neat.ActivationFunction;

/**
 * How offspring differ from their parents.
 *
 * @param rates mutation rates
 * @param gate when a module may be added
 * @param crossoverExcessRate probability that a crossover gives both children all genes that only one parent has, in [0, 1]
 *     ({@code crossExcessRate})
 * @param isLeastUsedModuleDeleted whether module deletion takes the least used module, else a random one ({@code
 *     deleteLeastUsed})
 * @param selection inputs that a new module is linked to
 * @param activation activation function of new neurons
 */
public record VariationSettings(
        MutationRates rates,
        ModuleGate gate,
        double crossoverExcessRate,
        boolean isLeastUsedModuleDeleted,
        InputSelection selection,
        ActivationFunction activation) {

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
        if (!(crossoverExcessRate >= 0 && crossoverExcessRate <= 1)) {
            throw new IllegalArgumentException("crossExcessRate must be in [0, 1], is " + crossoverExcessRate);
        }
    }

    /** The settings of the published experiments, with other mutation rates. */
    public VariationSettings(MutationRates rates) {
        this(rates, ModuleGate.PUBLISHED, 0, false, InputSelection.ALL, ActivationFunction.TANH);
    }
}
