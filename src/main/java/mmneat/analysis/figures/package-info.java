/**
 * Figures like those of the paper, drawn from the data of runs, with the paper's data in grey behind them, as SVG and
 * PNG. {@link mmneat.experiment} explains the terms: the paper, run, method, version, champion, module.
 */
@NullMarked
package mmneat.analysis.figures;

import org.jspecify.annotations.NullMarked;
