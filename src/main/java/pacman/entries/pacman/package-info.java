/**
 * The skeleton of a competition entry that controls Ms.&nbsp;Pac-Man. Entries of the competition have this package,
 * too.
 */
@NullMarked
package pacman.entries.pacman;

import org.jspecify.annotations.NullMarked;
