/** Recordings made of games that champions play, which later experiments start from. */
package mmneat.analysis.recording;
