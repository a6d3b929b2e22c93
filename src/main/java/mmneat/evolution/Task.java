package mmneat.evolution;

import java.util.List;
import java.util.function.BiFunction;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;

/**
 * The domain for which networks are evolved: it evaluates genotypes. Implement this interface for your own domain, or
 * call {@link #of} with an evaluation function. An implementation needs four methods: {@link #objectiveNames}, {@link
 * #inputLabels}, {@link #policyNeuronsPerModule} and {@link #evaluate}. The others have defaults.
 *
 * <p>An instance is used by one thread at a time. All methods except {@link #evaluate} always return the same values.
 * An evaluation depends only on the genotype and the generator, so that a run can be repeated and resumed.
 *
 * <p>Source: docs/specification/evolution.md, section 1.3.
 */
public interface Task {

    /**
     * Creates a task from an evaluation function.
     *
     * @param objectives names of the objectives, all maximised
     * @param inputs labels of the inputs of a network, which also determine their number
     * @param policyNeuronsPerModule number of policy neurons in each output module of a network
     * @param evaluation as {@link #evaluate}
     */
    static Task of(
            List<String> objectives,
            List<String> inputs,
            int policyNeuronsPerModule,
            BiFunction<Genotype, ResumableRandom, Evaluation> evaluation) {
        return new FunctionTask(objectives, inputs, policyNeuronsPerModule, evaluation);
    }

    /** Names of the objectives, all maximised, in the order of {@link Evaluation#objectives()}; at least one. */
    List<String> objectiveNames();

    /**
     * The worst score possible in each objective, from which a hypervolume is measured: 0 unless a task says otherwise.
     *
     * @return one number per objective
     */
    default double[] referencePoint() {
        return new double[objectiveNames().size()];
    }

    /**
     * Whether the scores of a genotype are the same in every evaluation. They can then be kept ({@code keepScores})
     * instead of being computed again in every generation. The evaluations of a deterministic task do not draw from the
     * run's generator: each gets its own generator, seeded with the genotype's id, for example for ties between
     * preference neurons.
     */
    default boolean isDeterministic() {
        return false;
    }

    /**
     * Names of the scores that are recorded but not used by selection, in the order of {@link
     * Evaluation#otherScores()}. Names may repeat.
     */
    default List<String> otherScoreNames() {
        return List.of();
    }

    /**
     * Labels of the other scores in summaries over runs: their names, with the statistic over trials if it is not the
     * average, for example {@code GameScore[Max]}.
     */
    default List<String> otherScoreLabels() {
        return otherScoreNames();
    }

    /**
     * Returns the score by which reports describe an individual: learning curves, and the score of a champion. Larger
     * is better. The default is the first objective.
     */
    default double championScore(Evaluation evaluation) {
        return evaluation.objectives()[0];
    }

    /**
     * Returns the number by which the champion of a generation is chosen: the last individual with the largest number
     * is the champion. It is separate from {@link #championScore}, its default, because a task may compare more
     * coarsely than it reports. The Ms.&nbsp;Pac-Man task does, as the original: it drops the fraction of the mean
     * score, so that a later individual with a slightly lower mean can be the champion.
     */
    default double championRank(Evaluation evaluation) {
        return championScore(evaluation);
    }

    /** Labels of the network's inputs, in order. */
    List<String> inputLabels();

    /** Number of inputs of a network. */
    default int inputs() {
        return inputLabels().size();
    }

    /** Number of policy neurons in each output module of a network. */
    int policyNeuronsPerModule();

    /** Number of trials in one evaluation. */
    default int trials() {
        return 1;
    }

    /**
     * Scores a genotype.
     *
     * @param genotype with {@link #inputs()} inputs and {@link #policyNeuronsPerModule()} policy neurons per module
     * @param random source of every random decision of the evaluation
     */
    Evaluation evaluate(Genotype genotype, ResumableRandom random);
}
