/**
 * The statistics of the paper: Kruskal-Wallis over all methods, then all pairs by the Mann-Whitney U test with
 * Bonferroni's correction, as R computes them (docs/specification/evolution.md, section 8), with effect sizes and
 * medians beside them. {@link mmneat.experiment} explains the terms: the paper, method, champion.
 */
@NullMarked
package mmneat.analysis.statistics;

import org.jspecify.annotations.NullMarked;
