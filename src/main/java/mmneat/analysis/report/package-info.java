/** One page about a set of experiments: settings, curves, statistics, champions. */
package mmneat.analysis.report;
