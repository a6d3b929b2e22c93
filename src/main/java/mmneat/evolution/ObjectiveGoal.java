package mmneat.evolution;

/**
 * The goal that TUG pursues in one objective, and how far the population is from it. Immutable.
 *
 * <p>Source: docs/specification/original-options.md, section 4.2.
 *
 * @param goal G: the score to be reached
 * @param average A: the recency-weighted average of the population's performance
 * @param lastStep D: the last step of the goal; 0 with constant increments
 * @param active a: whether selection uses the objective
 * @param climbing c: whether the goal has not been reached since it last changed
 */
public record ObjectiveGoal(double goal, double average, double lastStep, boolean active, boolean climbing) {

    /**
     * A checked goal.
     *
     * @throws IllegalArgumentException if a number is not finite
     */
    public ObjectiveGoal {
        if (!Double.isFinite(goal) || !Double.isFinite(average) || !Double.isFinite(lastStep)) {
            throw new IllegalArgumentException(
                    "goal, average and last step must be finite, are " + goal + ", " + average + " and " + lastStep);
        }
    }

    /** The goal at the start of a run. */
    static ObjectiveGoal initial(double goal, double average) {
        return new ObjectiveGoal(goal, average, 0, true, true);
    }

    ObjectiveGoal withGoal(double newGoal) {
        return new ObjectiveGoal(newGoal, average, lastStep, active, climbing);
    }

    ObjectiveGoal withAverage(double newAverage) {
        return new ObjectiveGoal(goal, newAverage, lastStep, active, climbing);
    }

    ObjectiveGoal raised(double newGoal, double step) {
        return new ObjectiveGoal(newGoal, average, step, true, climbing);
    }

    ObjectiveGoal withActive(boolean active) {
        return new ObjectiveGoal(goal, average, lastStep, active, climbing);
    }

    ObjectiveGoal withClimbing(boolean climbing) {
        return new ObjectiveGoal(goal, average, lastStep, active, climbing);
    }
}
