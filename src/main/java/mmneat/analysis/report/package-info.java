/**
 * The report of a set of experiments as a web page: figures, statistics, champions and settings. {@link
 * mmneat.experiment} explains the terms.
 */
@NullMarked
package mmneat.analysis.report;

import org.jspecify.annotations.NullMarked;
