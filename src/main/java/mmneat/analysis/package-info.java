/**
 * Analysis of finished runs: evaluation of champions, comparison of methods, figures, reports, and recordings of games.
 *
 * <p>{@link mmneat.experiment} explains the terms: the original, the paper, run, experiment, method ({@code 1M} to
 * {@code MT3}), version of the task, trial, module, champion. In short: a champion is the network of a run with the
 * best mean game score in the last generation that had children, and "published" means: of the paper.
 *
 * <table>
 *   <caption>Subpackages</caption>
 *   <tr><th>package</th><th>start with</th></tr>
 *   <tr><td>{@link mmneat.analysis.results}</td>
 *       <td>{@link mmneat.analysis.results.ExperimentFinder}: reads the folders of finished runs</td></tr>
 *   <tr><td>{@link mmneat.analysis.evaluation}</td>
 *       <td>{@link mmneat.analysis.evaluation.ChampionEvaluator}: plays many games with a champion</td></tr>
 *   <tr><td>{@link mmneat.analysis.statistics}</td>
 *       <td>{@link mmneat.analysis.statistics.ComparisonReport}: tests and tables</td></tr>
 *   <tr><td>{@link mmneat.analysis.figures}</td>
 *       <td>{@link mmneat.analysis.figures.LearningCurveFigure}: the paper's figures</td></tr>
 *   <tr><td>{@link mmneat.analysis.report}</td>
 *       <td>{@link mmneat.analysis.report.ExperimentReport}: all of these on one page</td></tr>
 *   <tr><td>{@link mmneat.analysis.replay}</td>
 *       <td>{@link mmneat.analysis.replay.GameRecording}: recordings of games for viewing</td></tr>
 *   <tr><td>{@link mmneat.analysis.recording}</td>
 *       <td>{@link mmneat.analysis.recording.GhostLocationRecorder}: ghost locations for the isolated version</td></tr>
 *   <tr><td>{@link mmneat.analysis.tasks}</td>
 *       <td>{@link mmneat.analysis.tasks.TaskMeter}: how the game divides into subtasks</td></tr>
 * </table>
 */
@NullMarked
package mmneat.analysis;

import org.jspecify.annotations.NullMarked;
