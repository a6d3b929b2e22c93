/**
 * The skeleton of a competition entry that controls Ms.&nbsp;Pac-Man. Entries of the competition have this package,
 * too.
 */
package pacman.entries.pacman;
