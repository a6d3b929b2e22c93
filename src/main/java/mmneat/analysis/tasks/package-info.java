/**
 * Measurement of a division of the game into subtasks: how often the subtask changes within a game, whether subtasks
 * overlap, and so whether they are isolated, interleaved or blended.
 *
 * <p>In this package a task is a subtask of the game, such as eating pills, as in section 3 of the paper. Elsewhere in
 * the program a task is the whole problem of an evolution ({@link mmneat.evolution.Task}). Only in the name {@link
 * mmneat.mspacman.TaskVersion} it has that meaning here, too. An episode is one game.
 *
 * <p>Source: section 3 of the paper (J. Schrum and R. Miikkulainen, Evolutionary Computation 24(3), 2016).
 */
@NullMarked
package mmneat.analysis.tasks;

import org.jspecify.annotations.NullMarked;
