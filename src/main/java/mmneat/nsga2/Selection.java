package mmneat.nsga2;

import java.util.function.ToIntFunction;
import mmneat.random.ResumableRandom;

/**
 * A way of selecting parents and survivors by their scores. An implementation of your own replaces NSGA-II's in an
 * evolution ({@code EvolutionSetup.selection} of {@code mmneat.evolution}). Its two methods have defaults, which select
 * as the published NSGA-II does: override one or both.
 *
 * <p>It keeps no state, and every random decision comes from the generator that is passed in: then a run can be
 * repeated and resumed. All scores are finite and maximised.
 */
public interface Selection {

    /**
     * Returns the function that chooses the parents of one generation. By default it holds binary tournaments by rank,
     * then by crowding distance within the front.
     *
     * @param scores {@code scores[individual][objective]}, at least one individual
     * @return a function that returns the index of an individual, called once for each parent that is needed
     */
    default ToIntFunction<ResumableRandom> parents(double[][] scores) {
        return Tournament.byCrowding(scores, NondominatedSorting.of(scores, Crowding.PER_FRONT))::winner;
    }

    /**
     * Returns the individuals that are the next parents. By default these are complete fronts, then the least crowded
     * individuals of the next front.
     *
     * @param scores {@code scores[individual][objective]}: parents followed by children
     * @param count number of survivors
     * @return their indices, each once, in the order in which they are the next parents
     */
    default int[] survivors(double[][] scores, int count, ResumableRandom random) {
        return SurvivorSelection.survivors(scores, count, Crowding.PER_FRONT);
    }
}
