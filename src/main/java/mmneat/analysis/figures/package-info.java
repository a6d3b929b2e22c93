/** The paper's figures from our runs, with the paper's own data behind them, drawn as SVG and PNG. */
package mmneat.analysis.figures;
