package mmneat.neat.variation;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;

/**
 * Small populations that reproduce at random, without selection, to generate all kinds of networks that evolution can
 * produce.
 */
public final class RandomLineages {

    private final Reproduction reproduction;
    private final GenePool pool;
    private final ResumableRandom random;
    private final List<Genotype> population;

    public RandomLineages(InitialNetworks networks, VariationSettings settings, int size, long seed) {
        random = new ResumableRandom(seed);
        pool = GenePool.foundedOn(networks.create(-1, random));
        population = new ArrayList<>(networks.createPopulation(size, pool, random));
        reproduction = new Reproduction(settings, pool);
    }

    public GenePool pool() {
        return pool;
    }

    public List<Genotype> population() {
        return population;
    }

    /** Reproduces a number of times. The offspring replace random members. The archetype is cleaned at intervals. */
    public void reproduce(int times, Consumer<Offspring> check) {
        for (int i = 0; i < times; i++) {
            Genotype first = evaluated(population.get(random.nextInt(population.size())));
            List<Offspring> children;
            if (random.nextBoolean()) {
                Genotype second = evaluated(population.get(random.nextInt(population.size())));
                children = reproduction.fromTwo(first, second, 1 + random.nextInt(2), random);
            } else {
                children = List.of(reproduction.fromOne(first, random));
            }
            for (Offspring child : children) {
                check.accept(child);
                population.set(random.nextInt(population.size()), child.genotype());
            }
            if (i % 25 == 24) {
                pool.archetype().clean(population);
            }
        }
    }

    /** Returns the parent with random module usage, even or uneven. */
    private Genotype evaluated(Genotype parent) {
        int[] usage = new int[parent.modules()];
        for (int i = 0; i < usage.length; i++) {
            usage[i] = random.nextInt(4) == 0 ? 0 : 100;
        }
        return parent.withModuleUsage(usage);
    }
}
