/**
 * Analysis of finished runs: evaluation of champions, comparison of methods, figures, reports, and recordings of games.
 */
package mmneat.analysis;
