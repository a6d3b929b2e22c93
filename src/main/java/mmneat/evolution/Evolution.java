package mmneat.evolution;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.ToIntFunction;
import java.util.stream.Stream;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.OwnPart;
import mmneat.neat.variation.Offspring;
import mmneat.neat.variation.Reproduction;
import mmneat.nsga2.Crowding;
import mmneat.nsga2.Selection;
import mmneat.nsga2.SurvivorSelection;
import mmneat.nsga2.Variation;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;

/**
 * The (mu+lambda) evolution of networks, lambda = mu, by NSGA-II, optionally with the objectives that TUG chooses. For
 * a new evolution call {@link #of}; a constructor continues from a saved {@link EvolutionState}.
 *
 * <p>Parents are passed to the evaluator again in every generation, so the scheme is elitist only with respect to the
 * current generation's noisy scores. A {@link ScoreKeepingEvaluator} returns their earlier scores instead. After the
 * last generation the final parents are evaluated once more.
 *
 * <p>Source: Schrum and Miikkulainen 2016, section 5.2; docs/specification/evolution.md, section 1.
 */
public final class Evolution {

    private final EvolutionSettings settings;
    private final Evaluator evaluator;
    private final EvolutionObserver observer;
    private final Predicate<List<Individual>> isSolved;

    private final GenePool pool;
    private final ResumableRandom random;
    private final Variation<Genotype, Offspring> variation;
    private List<Genotype> population;
    private int generation;
    private @Nullable TugState tug;

    /**
     * An evolution that continues from a state. A new evolution starts from {@link EvolutionState#initial}.
     *
     * @throws IllegalArgumentException if the state has another population size than the settings, or goals that do not
     *     fit them
     */
    public Evolution(
            EvolutionSettings settings, EvolutionState state, Evaluator evaluator, EvolutionObserver observer) {
        this(settings, state, evaluator, observer, parents -> false);
    }

    /**
     * An evolution that continues from a state and may end before its last generation.
     *
     * @param isSolved called after the parents of each generation have been evaluated; if it returns true, the
     *     evolution ends with them
     * @throws IllegalArgumentException if the state has another population size than the settings
     */
    public Evolution(
            EvolutionSettings settings,
            EvolutionState state,
            Evaluator evaluator,
            EvolutionObserver observer,
            Predicate<List<Individual>> isSolved) {
        if (state.population().size() != settings.populationSize()) {
            throw new IllegalArgumentException("population size mismatch: " + settings.populationSize()
                    + " in the settings, " + state.population().size() + " in the state");
        }
        this.settings = settings;
        this.evaluator = evaluator;
        this.observer = observer;
        this.isSolved = isSolved;
        pool = GenePool.resume(state.pool());
        random = ResumableRandom.resume(state.random());
        variation = new ReproductionVariation(new Reproduction(settings.variation(), pool));
        population = state.bound(settings.initialNetworks().activation()).population();
        generation = state.generation();
        tug = state.tug();
        settings.tug().ifPresent(policy -> policy.requireFitting(tug));
    }

    /**
     * Starts to set up the evolution of networks for a task: {@code Evolution.of(task).generations(50).seed(1).run()}.
     */
    public static EvolutionSetup of(Task task) {
        return new EvolutionSetup(task);
    }

    /**
     * Evolves to the end.
     *
     * @return the final parents, evaluated
     * @throws java.util.concurrent.CancellationException if the thread is interrupted; the observer has seen the last
     *     complete generation
     * @throws BadEvaluationException as {@link Evaluator#evaluate}
     * @throws IllegalStateException if an evaluation fails, or a module is to be added to a multitask network
     * @throws mmneat.neat.BadPartException if a selection, mutation operator or crossover of the caller's own fails or
     *     gives something invalid
     */
    public Generation run() {
        List<Individual> parents = evaluateParents();
        while (generation < settings.generations() && !isSolved.test(parents)) {
            evolve(parents);
            parents = evaluateParents();
        }
        Generation last = new Generation(
                generation, parents, List.of(), List.of(), pool.archetype().size());
        observer.completed(last);
        return last;
    }

    /** Completes the generation of evaluated parents. */
    private void evolve(List<Individual> parents) {
        Optional<TugStep> tugStep = settings.tug().map(policy -> policy.step(goals(), generation, objectives(parents)));
        tugStep.ifPresent(step -> tug = step.after());
        List<Offspring> offspring = reproduce(parents);
        List<Individual> children =
                evaluate(offspring.stream().map(Offspring::genotype).toList(), parents.size(), 2 * parents.size());
        // The archetype's size is recorded before cleaning: it includes the neurons of children that will not survive.
        Generation completed = new Generation(
                generation, parents, offspring, children, pool.archetype().size(), tugStep);

        population = survivors(parents, children);
        generation++;
        if (generation % settings.cleanFrequency() == 0) {
            pool.archetype().clean(population);
        }
        observer.generationCompleted(completed, state());
    }

    private List<Individual> evaluateParents() {
        boolean isLast = generation >= settings.generations();
        return evaluate(population, 0, isLast ? population.size() : 2 * population.size());
    }

    private List<Individual> evaluate(List<Genotype> genotypes, int firstIndex, int total) {
        int[] done = {firstIndex};
        return evaluator.evaluate(
                genotypes,
                generation,
                firstIndex,
                random,
                individual -> observer.evaluated(generation, ++done[0], total, individual));
    }

    private List<Offspring> reproduce(List<Individual> parents) {
        List<Genotype> genotypes = parents.stream().map(Individual::genotype).toList();
        double[][] scores = selectionScores(parents);
        if (settings.ownSelection().isPresent()) {
            return settings.parentSelection()
                    .children(
                            genotypes,
                            ownChoice(settings.ownSelection().get(), scores),
                            settings.populationSize(),
                            variation,
                            random);
        }
        return settings.parentSelection()
                .children(genotypes, scores, generation == 0, settings.populationSize(), variation, random);
    }

    private List<Genotype> survivors(List<Individual> parents, List<Individual> children) {
        List<Individual> all =
                Stream.concat(parents.stream(), children.stream()).toList();
        int count = settings.populationSize();
        Crowding crowding = settings.parentSelection().crowding();
        double[][] scores = objectives(all);
        int[] survivors = settings.ownSelection().isPresent()
                ? ownSurvivors(settings.ownSelection().get(), scores, count)
                : settings.tug()
                        .map(policy -> policy.survivors(goals(), generation, scores, count, crowding))
                        .orElseGet(() -> SurvivorSelection.survivors(scores, count, crowding));
        return Arrays.stream(survivors).mapToObj(i -> all.get(i).genotype()).toList();
    }

    private static ToIntFunction<ResumableRandom> ownChoice(Selection selection, double[][] scores) {
        OwnPart part = OwnPart.of("selection", selection);
        ToIntFunction<ResumableRandom> choice = part.call(() -> selection.parents(scores));
        if (choice == null) {
            throw part.bad("parents gave null");
        }
        return random -> {
            int parent = part.call(() -> choice.applyAsInt(random));
            if (parent < 0 || parent >= scores.length) {
                throw part.bad("chose parent " + parent + "; parents are 0 to " + (scores.length - 1));
            }
            return parent;
        };
    }

    private int[] ownSurvivors(Selection selection, double[][] scores, int count) {
        OwnPart part = OwnPart.of("selection", selection);
        int[] survivors = part.call(() -> selection.survivors(scores, count, random));
        problem(survivors, scores.length, count).ifPresent(problem -> {
            throw part.bad("the selection must name " + count + " different survivors of " + scores.length + ", 0 to "
                    + (scores.length - 1) + "; it named " + problem);
        });
        return survivors;
    }

    /** What is wrong with the survivors of a selection; empty if nothing is. */
    private static Optional<String> problem(int @Nullable [] survivors, int candidates, int count) {
        if (survivors == null) {
            return Optional.of("null");
        }
        if (survivors.length != count) {
            return Optional.of(Integer.toString(survivors.length));
        }
        BitSet named = new BitSet(candidates);
        for (int survivor : survivors) {
            if (survivor < 0 || survivor >= candidates) {
                return Optional.of("number " + survivor);
            }
            if (named.get(survivor)) {
                return Optional.of("number " + survivor + " twice");
            }
            named.set(survivor);
        }
        return Optional.empty();
    }

    private double[][] selectionScores(List<Individual> individuals) {
        double[][] scores = objectives(individuals);
        return settings.tug()
                .map(policy -> policy.activeScores(goals(), generation, scores))
                .orElse(scores);
    }

    /** The goals of TUG, which its settings have made sure are there. */
    private TugState goals() {
        return Objects.requireNonNull(tug, "TUG without goals");
    }

    private static double[][] objectives(List<Individual> individuals) {
        return individuals.stream()
                .map(individual -> individual.evaluation().objectives())
                .toArray(double[][]::new);
    }

    private EvolutionState state() {
        return new EvolutionState(generation, population, pool.state(), random.state(), tug);
    }

    /** NEAT's variation in the form that NSGA-II requires. */
    private record ReproductionVariation(Reproduction reproduction) implements Variation<Genotype, Offspring> {

        @Override
        public Offspring fromOne(Genotype parent, ResumableRandom random) {
            return reproduction.fromOne(parent, random);
        }

        @Override
        public List<Offspring> fromTwo(Genotype parent, Genotype mate, int room, ResumableRandom random) {
            return reproduction.fromTwo(parent, mate, room, random);
        }
    }
}
