/** The skeleton of a competition entry that controls the ghosts. Entries of the competition have this package, too. */
@NullMarked
package pacman.entries.ghosts;

import org.jspecify.annotations.NullMarked;
