package mmneat.neat.variation;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import mmneat.random.ResumableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Measures the reproduction of 100 children from 100 parents of a champion's size: 30 inputs, two modules, 25 hidden
 * neurons, 180 links on average; two thirds of the children by crossover.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(3)
@State(Scope.Thread)
public class ReproductionBenchmark {

    private static final int SIZE = 100;
    private static final int HIDDEN = 25;
    private static final int LINKS = 180;

    private final List<Genotype> parents = new ArrayList<>();
    private GenePool.State start;
    private Reproduction reproduction;
    private ResumableRandom random;

    /**
     * Reproduces at random from one population, so that parents share genes and the archetype is as long as in a run.
     */
    @Setup
    public void growParents() {
        random = new ResumableRandom(1);
        InitialNetworks networks = new InitialNetworks(30, ModuleLayout.withPreferenceNeurons(2, 1));
        GenePool pool = GenePool.foundedOn(networks.create(-1, random));
        parents.clear();
        parents.addAll(networks.createPopulation(SIZE, pool, random));
        Reproduction linking = growing(pool, 0.9, 0);
        Reproduction splicing = growing(pool, 0.9, 0.5);
        while (meanHidden() < HIDDEN || meanLinks() < LINKS) {
            Reproduction reproduction = meanHidden() < HIDDEN ? splicing : linking;
            List<Genotype> children = reproduce(reproduction);
            parents.clear();
            parents.addAll(children);
            pool.archetype().clean(parents);
        }
        parents.replaceAll(parent -> parent.withModuleUsage(new int[] {600, 400}));
        start = pool.state();
    }

    private static Reproduction growing(GenePool pool, double newLink, double splice) {
        MutationRates rates = MutationRates.PUBLISHED;
        return new Reproduction(
                new VariationSettings(new MutationRates(
                        newLink, splice, 0.05, 0, rates.module(), rates.deletion(), rates.freezing())),
                pool);
    }

    private double meanHidden() {
        return parents.stream().mapToInt(Genotype::hidden).average().orElse(0);
    }

    private double meanLinks() {
        return parents.stream()
                .mapToInt(parent -> parent.links().size())
                .average()
                .orElse(0);
    }

    /** Every generation starts from the same archetype. */
    @Setup(Level.Invocation)
    public void resumePool() {
        reproduction = new Reproduction(new VariationSettings(MutationRates.PUBLISHED), GenePool.resume(start));
    }

    /** One generation. */
    @Benchmark
    public List<Genotype> generation() {
        return reproduce(reproduction);
    }

    private List<Genotype> reproduce(Reproduction reproduction) {
        List<Genotype> children = new ArrayList<>(SIZE);
        while (children.size() < SIZE) {
            Genotype parent = parents.get(random.nextInt(SIZE));
            if (random.nextBoolean()) {
                Genotype other = parents.get(random.nextInt(SIZE));
                for (Offspring child : reproduction.fromTwo(parent, other, SIZE - children.size(), random)) {
                    children.add(child.genotype());
                }
            } else {
                children.add(reproduction.fromOne(parent, random).genotype());
            }
        }
        return children;
    }
}
