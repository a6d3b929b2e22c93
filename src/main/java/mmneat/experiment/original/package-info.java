/**
 * The files of a run in the original's formats, byte for byte, and the summaries over runs.
 *
 * <p>Source: docs/specification/evolution.md, sections 5 and 7.
 */
package mmneat.experiment.original;
