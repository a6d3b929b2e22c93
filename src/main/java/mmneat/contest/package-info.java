/**
 * Contests: many games between two controllers, their scores, and the handling of controllers that fail. {@link
 * mmneat.contest.Contest} is the entry point; the command {@code play} uses it.
 *
 * <p>Terms:
 *
 * <ul>
 *   <li><b>Controller</b>: a {@link pacman.controllers.Controller}, the player of Ms.&nbsp;Pac-Man or of the four
 *       ghosts.
 *   <li><b>Contest</b>: a series of games between two controllers, played by this program.
 *   <li><b>The competition</b>: the Ms.&nbsp;Pac-Man versus Ghosts competition of 2011 and 2012, from which the
 *       simulator and its programming interface come (release 6.2). An <b>entry</b> is a controller written for it.
 *   <li><b>Timed game</b>: each controller computes in a thread of its own and has 40 ms per step; if it is late, its
 *       last answer is used again. In an <b>untimed</b> game the program waits for each answer ({@link
 *       mmneat.contest.Timing}).
 * </ul>
 *
 * <p>{@link mmneat.experiment} explains other terms, such as the original and the versions of the task.
 */
@NullMarked
package mmneat.contest;

import org.jspecify.annotations.NullMarked;
