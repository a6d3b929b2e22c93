/**
 * The skeleton of a competition entry that controls Ms.&nbsp;Pac-Man.
 */
package pacman.entries.pacman;
