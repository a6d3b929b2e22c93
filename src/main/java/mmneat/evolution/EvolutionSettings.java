package mmneat.evolution;

import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import mmneat.neat.ModuleLayout;
import mmneat.neat.variation.InitialNetworks;
import mmneat.neat.variation.MutationRates;
import mmneat.neat.variation.VariationSettings;
import mmneat.nsga2.Crowding;
import mmneat.nsga2.ParentSelection;
import mmneat.nsga2.Selection;

/**
 * The settings of an evolution, besides its task.
 *
 * <p>Source: docs/specification/evolution.md, sections 1 to 3.
 *
 * @param seed seed of the run's generator
 * @param initialPopulationSeed separate seed of the initial population, if there is one
 * @param populationSize number of parents, and of children per generation
 * @param generations number of generations in which children are made
 * @param cleanFrequency generations between cleanings of the archetype
 * @param initialNetworks the networks that evolution starts from
 * @param parentSelection how parents are chosen, and how survivors' crowding is measured
 * @param variation how offspring differ from their parents
 * @param tug the policy that leaves objectives out of selection, if there is one (the parameter {@code ea} of the
 *     command line switches it on)
 * @param ownSelection a selection of parents and survivors of your own that replaces NSGA-II's; usually none
 */
public record EvolutionSettings(
        long seed,
        OptionalInt initialPopulationSeed,
        int populationSize,
        int generations,
        int cleanFrequency,
        InitialNetworks initialNetworks,
        ParentSelection parentSelection,
        VariationSettings variation,
        Optional<Tug> tug,
        Optional<Selection> ownSelection) {

    /**
     * Checked settings.
     *
     * @throws IllegalArgumentException if there are no parents, less than 0 generations or less than 1 between
     *     cleanings, or both TUG and a selection of the caller's own
     * @throws NullPointerException if a part is missing; the message names it
     */
    public EvolutionSettings {
        requireAtLeast(1, "populationSize", populationSize);
        requireAtLeast(0, "generations", generations);
        requireAtLeast(1, "cleanFrequency", cleanFrequency);
        Objects.requireNonNull(initialPopulationSeed, "initialPopulationSeed");
        Objects.requireNonNull(initialNetworks, "initialNetworks");
        Objects.requireNonNull(parentSelection, "parentSelection");
        Objects.requireNonNull(variation, "variation");
        Objects.requireNonNull(tug, "tug");
        if (ownSelection.isPresent() && tug.isPresent()) {
            throw new IllegalArgumentException("TUG cannot be combined with a selection of your own");
        }
    }

    /** Settings with which selection always uses all objectives. */
    public EvolutionSettings(
            long seed,
            OptionalInt initialPopulationSeed,
            int populationSize,
            int generations,
            int cleanFrequency,
            InitialNetworks initialNetworks,
            ParentSelection parentSelection,
            VariationSettings variation) {
        this(
                seed,
                initialPopulationSeed,
                populationSize,
                generations,
                cleanFrequency,
                initialNetworks,
                parentSelection,
                variation,
                Optional.empty(),
                Optional.empty());
    }

    /**
     * The settings of the published experiments for networks that start with one module: 100 parents, 200 generations,
     * seed 0.
     *
     * @throws IllegalArgumentException if the task has no inputs or no policy neurons
     */
    public static EvolutionSettings published(Task task) {
        return new EvolutionSettings(
                0,
                OptionalInt.empty(),
                100,
                200,
                10,
                new InitialNetworks(task.inputs(), ModuleLayout.single(task.policyNeuronsPerModule())),
                new ParentSelection(true, 0.5, Crowding.WHOLE_POPULATION),
                new VariationSettings(MutationRates.PUBLISHED));
    }

    /** These settings with a selection of the caller's own. */
    public EvolutionSettings withSelection(Selection selection) {
        return new EvolutionSettings(
                seed,
                initialPopulationSeed,
                populationSize,
                generations,
                cleanFrequency,
                initialNetworks,
                parentSelection,
                variation,
                tug,
                Optional.of(selection));
    }

    private static void requireAtLeast(int least, String name, int value) {
        if (value < least) {
            throw new IllegalArgumentException(name + " must be at least " + least + ", is " + value);
        }
    }
}
