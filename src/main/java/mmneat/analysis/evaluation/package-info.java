/**
 * Evaluation of champions after evolution: many games under chosen rules, their statistics and reports. {@link
 * mmneat.experiment} explains the terms.
 */
@NullMarked
package mmneat.analysis.evaluation;

import org.jspecify.annotations.NullMarked;
