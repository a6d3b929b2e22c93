/**
 * Recordings of champions' games from which later experiments start: the places of the ghosts at which the ghost-eating
 * games of the isolated version of the task begin. {@link mmneat.experiment} explains the terms.
 */
@NullMarked
package mmneat.analysis.recording;

import org.jspecify.annotations.NullMarked;
