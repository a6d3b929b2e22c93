/** The skeleton of a competition entry that controls the ghosts. Entries of the competition have this package, too. */
package pacman.entries.ghosts;
