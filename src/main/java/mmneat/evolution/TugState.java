package mmneat.evolution;

import java.util.List;
import java.util.Objects;

/**
 * The state of TUG between two generations: a goal per objective, and the values common to all objectives. Immutable.
 *
 * <p>Source: docs/specification/original-options.md, section 4.2.
 *
 * @param goals by objective
 * @param lastIncrease L: the generation in which goals rose last, 0 at the start
 * @param dropPossible whether goals are still multiplied by {@link TugSettings#remainingRatio}. It is true at the start
 *     and, with {@link TugSettings.Option#STOP_DROPPING_AFTER_SUCCESS}, false after all goals were reached once
 */
public record TugState(List<ObjectiveGoal> goals, int lastIncrease, boolean dropPossible) {

    /**
     * A state with a copy of the goals.
     *
     * @throws IllegalArgumentException if there is no goal or {@code lastIncrease} is negative
     * @throws NullPointerException if the goals are missing
     */
    public TugState {
        goals = List.copyOf(Objects.requireNonNull(goals, "goals"));
        if (goals.isEmpty()) {
            throw new IllegalArgumentException("goals must not be empty");
        }
        if (lastIncrease < 0) {
            throw new IllegalArgumentException("lastIncrease must not be negative, is " + lastIncrease);
        }
    }

    /** Whether selection uses each objective. */
    boolean[] active() {
        boolean[] active = new boolean[goals.size()];
        for (int objective = 0; objective < active.length; objective++) {
            active[objective] = goals.get(objective).active();
        }
        return active;
    }
}
