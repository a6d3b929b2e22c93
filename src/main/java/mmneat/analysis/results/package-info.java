/** What there is to analyse: the folders of finished runs, the evaluations of their champions, and the published numbers. */
package mmneat.analysis.results;
