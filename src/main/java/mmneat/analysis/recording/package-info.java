/** Recordings of champions' games from which later experiments start. */
package mmneat.analysis.recording;
