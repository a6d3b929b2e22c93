package mmneat.analysis.tasks;

import java.util.function.Predicate;
import mmneat.mspacman.sensors.Observation;

/**
 * A predicate on states of a game: whether a task is to be done in a state.
 *
 * @param name of the task
 * @param holds whether the task is to be done; looks at the state, not at a direction, and keeps no state of its own
 */
public record TaskPredicate(String name, Predicate<Observation> holds) {}
