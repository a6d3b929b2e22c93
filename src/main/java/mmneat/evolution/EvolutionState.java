package mmneat.evolution;

import java.util.List;
import java.util.Objects;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import mmneat.random.ResumableRandom;

/**
 * An evolution between two generations: everything that decides how it goes on. An {@link Evolution} made from a state
 * continues exactly as the one that was in that state. The population's genes are the pool's: the two belong together.
 *
 * @param generation number of the generation to come, which is also how many are done
 * @param population its parents, in the order in which they will be evaluated
 * @param pool counters and archetype
 * @param random the generator
 * @param tug the goals of TUG; null if the run does not use it
 */
public record EvolutionState(
        int generation, List<Genotype> population, GenePool.State pool, ResumableRandom.State random, TugState tug) {

    /** Id that the original gives to the network by which the archetype is made. */
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
     * The state in which a new evolution begins.
     *
     * <p>An example network is made first, from which the archetype is copied; then the population. Then the generator starts
     * again: evolution reuses the numbers that made the example and the population, as in the original.
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
     * Makes sure that this state, which may come from a file, is one that an evolution with these settings can be in.
     *
     * @throws IllegalArgumentException if the population has another size or other inputs, outputs or modules than the settings
     *     make, if two genotypes have one id, or if the population is not of the pool; the message says which
     */
    public void requireReachable(EvolutionSettings settings) {
        if (population.size() != settings.populationSize()) {
            throw new IllegalArgumentException(
                    "the population has " + population.size() + " genotypes, mu is " + settings.populationSize());
        }
        int inputs = settings.initialNetworks().inputs();
        ModuleLayout layout = settings.initialNetworks().layout();
        for (Genotype genotype : population) {
            boolean isOfTask = genotype.inputs() == inputs
                    && genotype.layout().policyNeuronsPerModule() == layout.policyNeuronsPerModule()
                    && genotype.layout().standardMultitask() == layout.standardMultitask();
            if (!isOfTask || layout.standardMultitask() && genotype.modules() != layout.modules()) {
                throw new IllegalArgumentException(genotype + " is no network for this task, which has " + inputs
                        + " inputs and " + layout.policyNeuronsPerModule() + " policy neurons a module");
            }
            if (genotype.moduleUsage().length > genotype.modules()) {
                throw new IllegalArgumentException("the module usage of " + genotype + " is of more modules");
            }
        }
        pool.requireOwn(population);
    }
}
