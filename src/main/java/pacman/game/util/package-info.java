/**
 * Files and a log for competition entries, as in the competition's programming interface.
 */
package pacman.game.util;
