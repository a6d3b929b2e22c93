/**
 * Recordings of games for viewing: a compact record of every step, shown as a self-contained HTML page, an animated GIF
 * or a window.
 */
package mmneat.analysis.replay;
