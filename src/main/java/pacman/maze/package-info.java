/**
 * Everything that depends on a maze alone: drawing, graph, distances, paths, corridors, the order of pills, and
 * walks.
 *
 * <p>{@link pacman.maze.MazeTables} gives access to all of it. Everything is immutable and shared between games and
 * threads.
 *
 * <p>Source: docs/specification/simulator.md, sections 1 and 4.
 */
package pacman.maze;
