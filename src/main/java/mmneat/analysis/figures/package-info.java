/**
 * Figures like those of the paper, drawn from the data of runs, with the paper's data in grey behind them, as SVG and
 * PNG.
 */
package mmneat.analysis.figures;
