package mmneat.evolution;

import java.util.Arrays;
import java.util.Objects;

/**
 * The result of evaluating a genotype: its scores, and how often each of its modules was chosen.
 *
 * @param objectives the scores that selection uses, all maximised and finite, in the order of {@link
 *     Task#objectiveNames()}
 * @param otherScores scores that are only recorded, all finite, in the order of {@link Task#otherScoreNames()}
 * @param moduleUsage how often each output module of the genotype was chosen: one count per module. Module mutation
 *     adds a module only if all modules were used enough, and logs show the counts. A task of your own counts all time
 *     steps ({@code NetworkState.moduleUsage}). The Ms.&nbsp;Pac-Man task counts only a part of them, a quirk of the
 *     original (docs/specification/networks.md, section 6.4)
 * @param outcomes counts of how the episodes of all trials ended
 */
public record Evaluation(double[] objectives, double[] otherScores, int[] moduleUsage, Outcomes outcomes) {

    /**
     * An evaluation with copies of the arrays.
     *
     * @throws NullPointerException if a part is missing; the message names it
     */
    public Evaluation {
        objectives = Objects.requireNonNull(objectives, "objectives").clone();
        otherScores = Objects.requireNonNull(otherScores, "otherScores").clone();
        moduleUsage = Objects.requireNonNull(moduleUsage, "moduleUsage").clone();
        Objects.requireNonNull(outcomes, "outcomes");
    }

    /** Creates an evaluation with neither other scores nor episodes. */
    public static Evaluation of(int[] moduleUsage, double... objectives) {
        return new Evaluation(objectives, new double[0], moduleUsage, Outcomes.NONE);
    }

    /** Returns a copy of the scores that selection uses. */
    @Override
    public double[] objectives() {
        return objectives.clone();
    }

    /** Returns a copy of the scores that are only recorded. */
    @Override
    public double[] otherScores() {
        return otherScores.clone();
    }

    /** Returns a copy of the counts of how often each output module was chosen. */
    @Override
    public int[] moduleUsage() {
        return moduleUsage.clone();
    }

    /**
     * Counts of how the episodes of an evaluation ended, and of simulated steps. An episode is a simulation from a
     * start to an end, such as one game; a trial has one or more. A task with episodes adds 1 to one of the first three
     * counts for each episode. Other tasks may leave them 0.
     *
     * @param succeeded episodes with everything done (all levels beaten)
     * @param timedOut episodes ended by a time limit
     * @param failed episodes ended by a failure (all lives lost)
     * @param steps simulated time steps
     */
    public record Outcomes(int succeeded, int timedOut, int failed, long steps) {

        /** The outcomes of an evaluation without episodes. */
        public static final Outcomes NONE = new Outcomes(0, 0, 0, 0);

        /**
         * Checked counts.
         *
         * @throws IllegalArgumentException if a count is negative
         */
        public Outcomes {
            requireNotNegative("succeeded", succeeded);
            requireNotNegative("timedOut", timedOut);
            requireNotNegative("failed", failed);
            requireNotNegative("steps", steps);
        }

        private static void requireNotNegative(String name, long count) {
            if (count < 0) {
                throw new IllegalArgumentException(name + " must not be negative, is " + count);
            }
        }

        /** Returns the sums of both. */
        public Outcomes plus(Outcomes other) {
            return new Outcomes(
                    succeeded + other.succeeded, timedOut + other.timedOut, failed + other.failed, steps + other.steps);
        }
    }

    /** Equal in every number. */
    @Override
    public boolean equals(Object other) {
        return other instanceof Evaluation that
                && Arrays.equals(objectives, that.objectives)
                && Arrays.equals(otherScores, that.otherScores)
                && Arrays.equals(moduleUsage, that.moduleUsage)
                && outcomes.equals(that.outcomes);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(objectives) * 31 + Arrays.hashCode(otherScores);
    }

    @Override
    public String toString() {
        return "objectives " + Arrays.toString(objectives) + ", other scores " + Arrays.toString(otherScores)
                + ", module usage " + Arrays.toString(moduleUsage) + ", " + outcomes;
    }
}
