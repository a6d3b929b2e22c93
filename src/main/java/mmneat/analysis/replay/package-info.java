/**
 * Recordings of games for viewing: a compact record of every step, shown as a self-contained HTML page, an animated GIF
 * or a window.
 *
 * <p>{@link mmneat.analysis.replay.GameRecording} plays and records a trial of a network; {@link
 * mmneat.analysis.replay.RecordedStates} converts a game that was recorded elsewhere. Both give a {@link
 * mmneat.analysis.replay.Replay}, of which {@link mmneat.analysis.replay.ReplayPage} makes the page. A trial is one
 * game, except in the isolated version of the task: there it is a set of five games.
 */
@NullMarked
package mmneat.analysis.replay;

import org.jspecify.annotations.NullMarked;
