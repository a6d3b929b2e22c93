/** The data of an analysis: folders of finished runs, evaluations of their champions, and published results. */
package mmneat.analysis.results;
