/**
 * The data of an analysis: folders of finished runs, evaluations of their champions, and published results, those of
 * the paper. {@link mmneat.experiment} explains the terms.
 */
@NullMarked
package mmneat.analysis.results;

import org.jspecify.annotations.NullMarked;
