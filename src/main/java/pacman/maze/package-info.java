/**
 * Precomputed tables of a maze: graph, distances, paths, corridors, the order of pills, and walks. They depend on the
 * drawing of the maze alone, not on the state of a game.
 *
 * <p>{@link pacman.maze.MazeTables} is the entrance: it holds the graph and makes the other tables on request. All
 * tables are immutable and shared between games and threads.
 *
 * <p>Choose a table by the length that is needed:
 *
 * <ul>
 *   <li>{@link pacman.maze.MazeDistances}: the exact shortest distance between two nodes.
 *   <li>{@link pacman.maze.MazePaths}: the path that the game gives to a controller or a ghost. It may forbid turning
 *       back, and is not always the shortest.
 *   <li>{@link pacman.maze.NonReversingSearch}: the search that finds the stored paths between junctions. Only the
 *       tables and the competition's own search class call it.
 * </ul>
 *
 * <p>{@link pacman.maze.Routes}, {@link pacman.maze.ApproachTables}, {@link pacman.maze.PillTables}, {@link
 * pacman.maze.OnwardJunctions} and {@link pacman.maze.WalkTables} are made for the sensors of networks, which ask the
 * same questions in every step.
 *
 * <p>Words of these tables: a <em>junction</em> is a node with at least three neighbours; a <em>corridor</em> is a
 * chain of nodes between two junctions; a <em>leg</em> is the way from a node along its corridor to a junction; a
 * <em>directed</em> path must not turn back. A <em>row</em> is the number of a pair of a junction and the move by which
 * it was entered; a <em>route</em> is a corridor ahead and the row at its end ({@link pacman.maze.Routes}).
 *
 * <p>Source: docs/specification/simulator.md, sections 1 and 4.
 */
@NullMarked
package pacman.maze;

import org.jspecify.annotations.NullMarked;
