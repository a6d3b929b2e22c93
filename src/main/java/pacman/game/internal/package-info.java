/**
 * Maze, path and actor classes that the competition's programming interface makes public.
 *
 * <p>They exist so that entries of the competition, written for release 6.2, compile and run unchanged. Some of their
 * public fields have no use of their own. A new controller needs none of these classes. The simulator itself uses the
 * tables of {@link pacman.maze}.
 *
 * <p>Source: docs/specification/simulator.md, section 1.4.
 */
@NullMarked
package pacman.game.internal;

import org.jspecify.annotations.NullMarked;
