package mmneat.evolution;

import java.util.List;
import java.util.Objects;
import mmneat.neat.ActivationFunction;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;

/**
 * The complete state of an evolution between two generations. An {@link Evolution} made from it continues exactly like
 * the evolution that was in this state. Population and pool belong together: the pool holds the innovation numbers of
 * the population's genes.
 *
 * @param generation number of the next generation, which equals the number of completed generations
 * @param population the parents of the next generation, in the order in which they will be evaluated
 * @param pool counters and archetype
 * @param random the generator
 * @param tug the goals of TUG; null if the run does not use it
 */
public record EvolutionState(
        int generation,
        List<Genotype> population,
        GenePool.State pool,
        ResumableRandom.State random,
        @Nullable TugState tug) {

    /** Id of the example network from which the original makes the archetype. */
    private static final long EXAMPLE_ID = -1;

    /**
     * A state with a copy of the population.
     *
     * @throws IllegalArgumentException if the generation is negative or the population empty
     * @throws NullPointerException if a part is missing; the message names it
     */
    public EvolutionState {
        if (generation < 0) {
            throw new IllegalArgumentException("generation must not be negative, is " + generation);
        }
        population = List.copyOf(Objects.requireNonNull(population, "population"));
        if (population.isEmpty()) {
            throw new IllegalArgumentException("population must not be empty");
        }
        Objects.requireNonNull(pool, "pool");
        Objects.requireNonNull(random, "random");
    }

    /**
     * Creates the state in which a new evolution starts.
     *
     * <p>First an example network is made, and the archetype is copied from it; then the population is made. Then the
     * generator is reset to its seed. So evolution draws the same random numbers that made the example and the
     * population, as in the original.
     *
     * <p>Source: docs/specification/evolution.md, section 3.1.
     */
    public static EvolutionState initial(EvolutionSettings settings) {
        ResumableRandom random = new ResumableRandom(settings.seed());
        Genotype example = settings.initialNetworks().create(EXAMPLE_ID, random);
        GenePool pool = GenePool.foundedOn(example);
        settings.initialPopulationSeed().ifPresent(random::setSeed);
        List<Genotype> population =
                settings.initialNetworks().createPopulation(settings.populationSize(), pool, random);
        random.setSeed(settings.seed());
        return new EvolutionState(
                0,
                population,
                pool.state(),
                random.state(),
                settings.tug().map(Tug::initial).orElse(null));
    }

    /**
     * Checks that an evolution with these settings can be in this state, which may come from a file.
     *
     * @throws IllegalArgumentException if the population has another size or other inputs, outputs or modules than the
     *     settings make, if it has an activation function of the user's own that is not theirs, if two genotypes have
     *     one id, or if the population does not belong to the pool; the message says which
     */
    public void requireReachable(EvolutionSettings settings) {
        if (population.size() != settings.populationSize()) {
            throw new IllegalArgumentException("population size mismatch: mu is " + settings.populationSize()
                    + ", but the population has " + population.size() + " genotypes");
        }
        int inputs = settings.initialNetworks().inputs();
        ModuleLayout layout = settings.initialNetworks().layout();
        for (Genotype genotype : population) {
            boolean isOfTask = genotype.inputs() == inputs
                    && genotype.layout().policyNeuronsPerModule() == layout.policyNeuronsPerModule()
                    && genotype.layout().standardMultitask() == layout.standardMultitask()
                    && genotype.layout().isGrouped() == layout.isGrouped();
            if (!isOfTask || layout.isDivided() && genotype.layout().choicesOfTask() != layout.choicesOfTask()) {
                throw new IllegalArgumentException(genotype + " does not fit this task, which has " + inputs
                        + " inputs and " + layout.policyNeuronsPerModule() + " policy neurons per module");
            }
            requireKnownFunctions(genotype, settings.initialNetworks().activation());
            if (genotype.moduleUsage().length > genotype.modules()) {
                throw new IllegalArgumentException("the module usage of " + genotype + " is that of a network with "
                        + genotype.moduleUsage().length + " modules");
            }
        }
        pool.requireOwn(population);
    }

    private static void requireKnownFunctions(Genotype genotype, ActivationFunction activation) {
        genotype.ownFunctionOtherThan(activation).ifPresent(unknown -> {
            throw new IllegalArgumentException(genotype + " has a neuron with the activation function " + unknown
                    + ", but the settings have " + activation);
        });
    }

    /** Returns this state with an activation function put into the neurons that have its name. */
    EvolutionState bound(ActivationFunction activation) {
        if (!activation.isOwn()) {
            return this;
        }
        List<Genotype> bound = population.stream()
                .map(genotype -> genotype.withFunctions(each -> each.equals(activation) ? activation : each))
                .toList();
        return new EvolutionState(generation, bound, pool, random, tug);
    }
}
