/**
 * The base classes of controllers, in the competition's programming interface.
 *
 * <p>To write a controller, extend {@link pacman.controllers.Controller} and implement {@code getMove}: it receives a
 * copy of the game and returns a move of Ms.&nbsp;Pac-Man, or a map with a move for each ghost. {@code
 * NewPacManController} and {@code NewGhostController} are classes that MM-NEAT added for tasks in which one controller
 * plays many games. {@link pacman} explains the words competition, MM-NEAT, entry and quirk.
 *
 * <p>Source: docs/specification/controllers.md, sections 2 and 3.
 */
@NullMarked
package pacman.controllers;

import org.jspecify.annotations.NullMarked;
