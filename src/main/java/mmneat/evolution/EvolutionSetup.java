package mmneat.evolution;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import mmneat.neat.ActivationFunction;
import mmneat.neat.ModuleLayout;
import mmneat.neat.variation.CrossoverOperator;
import mmneat.neat.variation.InitialNetworks;
import mmneat.neat.variation.MutationOperator;
import mmneat.neat.variation.MutationRates;
import mmneat.neat.variation.VariationSettings;
import mmneat.nsga2.Selection;

/**
 * A builder of an evolution, started by {@link Evolution#of} and finished by {@link #run}. Settings that are not set
 * are those of the published experiments ({@link EvolutionSettings#published}).
 *
 * <p>The task reports how often each module was chosen ({@link Evaluation#moduleUsage}); module mutation uses these
 * counts.
 */
public final class EvolutionSetup {

    private final Task task;
    private final List<EvolutionObserver> observers = new ArrayList<>();
    private EvolutionSettings settings;
    private Evaluator evaluator;

    EvolutionSetup(Task task) {
        this.task = Objects.requireNonNull(task, "task");
        settings = EvolutionSettings.published(task);
        evaluator = new SequentialEvaluator(task);
    }

    /** Replaces all settings. */
    public EvolutionSetup settings(EvolutionSettings all) {
        settings = Objects.requireNonNull(all, "settings");
        return this;
    }

    /** Sets the seed of every random decision. */
    public EvolutionSetup seed(long seed) {
        return with(seed, settings.populationSize(), settings.generations());
    }

    /**
     * Sets the number of parents, and of children per generation.
     *
     * @throws IllegalArgumentException if it is less than 1
     */
    public EvolutionSetup populationSize(int size) {
        return with(settings.seed(), size, settings.generations());
    }

    /**
     * Sets the number of generations in which children are made.
     *
     * @throws IllegalArgumentException if it is less than 0
     */
    public EvolutionSetup generations(int count) {
        return with(settings.seed(), settings.populationSize(), count);
    }

    /**
     * Starts with networks that have this number of output modules and a preference neuron in each. Use 1 if mutation
     * adds the modules.
     *
     * @throws IllegalArgumentException if it is less than 1
     */
    public EvolutionSetup modules(int count) {
        InitialNetworks networks = settings.initialNetworks();
        ModuleLayout layout = ModuleLayout.withPreferenceNeurons(count, task.policyNeuronsPerModule());
        return with(
                new InitialNetworks(networks.inputs(), layout, networks.selection(), networks.activation()),
                settings.variation());
    }

    /** Sets the activation function of all neurons, inputs included. */
    public EvolutionSetup activation(ActivationFunction function) {
        InitialNetworks networks = settings.initialNetworks();
        return with(
                new InitialNetworks(networks.inputs(), networks.layout(), networks.selection(), function),
                settings.variation().withActivation(function));
    }

    /** Sets the rates of the mutation operators. */
    public EvolutionSetup rates(MutationRates rates) {
        return with(settings.initialNetworks(), settings.variation().withRates(rates));
    }

    /**
     * Adds a mutation operator of the caller's own.
     *
     * @param rate probability that it is tried on an offspring
     * @throws IllegalArgumentException if the rate is not in [0, 1]
     */
    public EvolutionSetup mutation(double rate, MutationOperator operator) {
        return with(settings.initialNetworks(), settings.variation().withMutation(rate, operator));
    }

    /** Selects parents and survivors in a way of the caller's own instead of NSGA-II's. */
    public EvolutionSetup selection(Selection selection) {
        settings = settings.withSelection(selection);
        return this;
    }

    /** Crosses networks in a way of the caller's own instead of NEAT's. */
    public EvolutionSetup crossover(CrossoverOperator crossover) {
        return with(settings.initialNetworks(), settings.variation().withCrossover(crossover));
    }

    /** Replaces the sequential evaluator. The new evaluator must evaluate the same task. */
    public EvolutionSetup evaluator(Evaluator other) {
        evaluator = Objects.requireNonNull(other, "evaluator");
        return this;
    }

    /** Adds an observer; observers are called in the order in which they were added. */
    public EvolutionSetup observer(EvolutionObserver observer) {
        observers.add(Objects.requireNonNull(observer, "observer"));
        return this;
    }

    /** Adds an observer that receives each completed generation, and the final parents. */
    public EvolutionSetup onGeneration(Consumer<Generation> consumer) {
        return observer(new EvolutionObserver() {
            @Override
            public void generationCompleted(Generation generation, EvolutionState next) {
                consumer.accept(generation);
            }

            @Override
            public void completed(Generation finalParents) {
                consumer.accept(finalParents);
            }
        });
    }

    /**
     * Evolves from the start to the end.
     *
     * @return the final parents, evaluated; {@link Generation#champion} is the best of them
     * @throws java.util.concurrent.CancellationException if the thread is interrupted
     * @throws BadEvaluationException if the task returns an invalid evaluation
     */
    public Generation run() {
        return new Evolution(settings, EvolutionState.initial(settings), evaluator, all(List.copyOf(observers))).run();
    }

    private EvolutionSetup with(long seed, int populationSize, int generations) {
        settings = new EvolutionSettings(
                seed,
                settings.initialPopulationSeed(),
                populationSize,
                generations,
                settings.cleanFrequency(),
                settings.initialNetworks(),
                settings.parentSelection(),
                settings.variation(),
                settings.tug(),
                settings.ownSelection());
        return this;
    }

    private EvolutionSetup with(InitialNetworks networks, VariationSettings variation) {
        settings = new EvolutionSettings(
                settings.seed(),
                settings.initialPopulationSeed(),
                settings.populationSize(),
                settings.generations(),
                settings.cleanFrequency(),
                networks,
                settings.parentSelection(),
                variation,
                settings.tug(),
                settings.ownSelection());
        return this;
    }

    private static EvolutionObserver all(List<EvolutionObserver> observers) {
        return new EvolutionObserver() {
            @Override
            public void evaluated(int generation, int done, int total, Individual individual) {
                observers.forEach(observer -> observer.evaluated(generation, done, total, individual));
            }

            @Override
            public void generationCompleted(Generation generation, EvolutionState next) {
                observers.forEach(observer -> observer.generationCompleted(generation, next));
            }

            @Override
            public void completed(Generation finalParents) {
                observers.forEach(observer -> observer.completed(finalParents));
            }
        };
    }
}
