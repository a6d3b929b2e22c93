/**
 * Example controllers of Ms.&nbsp;Pac-Man and of the ghosts, among them the ghost team of the published experiments,
 * {@link pacman.controllers.examples.Legacy}.
 *
 * <p>Source: docs/specification/controllers.md, section 5.
 */
@NullMarked
package pacman.controllers.examples;

import org.jspecify.annotations.NullMarked;
