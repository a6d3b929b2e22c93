/**
 * The files of a run in the original's formats, byte for byte, and the summaries over runs. The original is MM-NEAT of
 * February 2016 ({@link mmneat.experiment} explains the terms).
 *
 * <p>Source: docs/specification/evolution.md, sections 5 and 7.
 */
@NullMarked
package mmneat.experiment.original;

import org.jspecify.annotations.NullMarked;
