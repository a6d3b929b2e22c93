/**
 * A game to watch: recorded step by step in a compact form, written as one self-contained HTML page.
 */
package mmneat.analysis.replay;
