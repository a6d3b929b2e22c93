/**
 * Maze, path and actor classes that the competition's programming interface makes public.
 *
 * <p>They exist for competition entries. The simulator itself uses the tables of {@link pacman.maze}.
 *
 * <p>Source: docs/specification/simulator.md, section 1.4.
 */
package pacman.game.internal;
