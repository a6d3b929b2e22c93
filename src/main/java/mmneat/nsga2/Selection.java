package mmneat.nsga2;

import java.util.function.ToIntFunction;
import mmneat.random.ResumableRandom;

/**
 * A way of selecting parents and survivors by their scores. An implementation of the user's own takes the place of
 * NSGA-II's in an evolution; what it does not override is as in NSGA-II.
 *
 * <p>It keeps no state, and every random decision comes from the generator that is passed in: then a run can be
 * repeated and resumed. All scores are finite and maximised.
 */
public interface Selection {

    /**
     * The way in which the parents of one generation are chosen; by default binary tournaments by rank, then by
     * crowding distance within the front.
     *
     * @param scores {@code scores[individual][objective]}, at least one individual
     * @return gives the index of an individual, once for each parent that is needed
     */
    default ToIntFunction<ResumableRandom> parents(double[][] scores) {
        return Tournament.byCrowding(scores, NondominatedSorting.of(scores, Crowding.PER_FRONT))::winner;
    }

    /**
     * The individuals that are the next parents; by default complete fronts, then the least crowded of the next front.
     *
     * @param scores {@code scores[individual][objective]}: parents followed by children
     * @param count number of survivors
     * @return their indices, each once, in the order in which they are the next parents
     */
    default int[] survivors(double[][] scores, int count, ResumableRandom random) {
        return SurvivorSelection.survivors(scores, count, Crowding.PER_FRONT);
    }
}
