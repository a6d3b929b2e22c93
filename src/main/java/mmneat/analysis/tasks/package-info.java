/**
 * Measures how a division of the game into tasks works out: how often the task changes, whether tasks overlap, and so
 * whether they are isolated, interleaved or blended.
 *
 * <p>Source: section 3 of the paper.
 */
package mmneat.analysis.tasks;
