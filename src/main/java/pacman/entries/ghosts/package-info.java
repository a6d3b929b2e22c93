/**
 * The skeleton of a competition entry that controls the ghosts.
 */
package pacman.entries.ghosts;
