/** The report of a set of experiments as a web page: figures, statistics, champions and settings. */
package mmneat.analysis.report;
