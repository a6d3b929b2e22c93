/**
 * The base classes of controllers, in the competition's programming interface.
 *
 * <p>To write a controller, extend {@link pacman.controllers.Controller} and implement {@code getMove}: it receives a
 * copy of the game and returns a move of Ms.&nbsp;Pac-Man, or a map with a move for each ghost.
 *
 * <p>Source: docs/specification/controllers.md, sections 2 and 3.
 */
package pacman.controllers;
