/**
 * Files and a log for competition entries, as in the competition's programming interface.
 */
@NullMarked
package pacman.game.util;

import org.jspecify.annotations.NullMarked;
