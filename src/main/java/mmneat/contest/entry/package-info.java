/**
 * Loading of controllers by class name: controllers of this program, and entries of the Ms.&nbsp;Pac-Man versus Ghosts
 * competition from a jar or class folder. {@link mmneat.contest.entry.ControllerLoader} is the entry point.
 */
@NullMarked
package mmneat.contest.entry;

import org.jspecify.annotations.NullMarked;
