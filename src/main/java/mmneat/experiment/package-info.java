/**
 * Experiments: evolutions that are run with given parameters, and the files that they write. The subpackages do the
 * work. This package itself holds only what all of them use: errors of the user, and checks and texts for messages.
 *
 * <table>
 *   <caption>Subpackages</caption>
 *   <tr><th>package</th><th>start with</th></tr>
 *   <tr><td>{@link mmneat.experiment.parameters}</td>
 *       <td>{@link mmneat.experiment.parameters.ParameterReader}: from words of a command line to checked
 *           values</td></tr>
 *   <tr><td>{@link mmneat.experiment.run}</td>
 *       <td>{@link mmneat.experiment.run.ExperimentRunner}: executes the runs of an experiment</td></tr>
 *   <tr><td>{@link mmneat.experiment.store}</td>
 *       <td>{@link mmneat.experiment.store.RunLayout}: the files in the folder of a run</td></tr>
 *   <tr><td>{@link mmneat.experiment.original}</td>
 *       <td>{@link mmneat.experiment.original.RunFiles}: the files in the original's formats</td></tr>
 *   <tr><td>{@link mmneat.experiment.cluster}</td>
 *       <td>{@link mmneat.experiment.cluster.ExperimentJob}: runs as jobs of a scheduler</td></tr>
 * </table>
 *
 * <h2>Terms</h2>
 *
 * <p>The packages {@code mmneat.experiment}, {@code mmneat.analysis}, {@code mmneat.contest} and {@code mmneat.cli} use
 * these terms. The full glossary is in docs/architecture.md.
 *
 * <ul>
 *   <li><b>The original</b>: MM-NEAT, the Java program of J. Schrum and R. Miikkulainen, as of February 2016. This
 *       program repeats its evolutions number for number.
 *   <li><b>The paper</b>: J. Schrum and R. Miikkulainen, <i>Solving Multiple Isolated, Interleaved, and Blended Tasks
 *       through Modular Neuroevolution</i>, Evolutionary Computation 24(3), 2016. Its sixteen experiments are called
 *       published.
 *   <li><b>Run, experiment, study</b>: one evolution with one seed; the runs of one set of parameters; a set of
 *       experiments.
 *   <li><b>Task</b>: the whole problem of an evolution, an implementation of {@link mmneat.evolution.Task}. The task of
 *       playing Ms.&nbsp;Pac-Man has three <b>versions</b>: blended, interleaved and isolated ({@link
 *       mmneat.mspacman.TaskVersion}). A <b>subtask</b> is a part of the game, such as eating pills.
 *   <li><b>Trial</b>: one game of an evaluation; in the isolated version the set of five games that are scored together
 *       (one game of eating pills, four of eating ghosts).
 *   <li><b>Module</b>: a group of output neurons of a network that can decide an action. Parameters and file formats of
 *       the original say "mode". Its <b>policy neurons</b> rate the actions. Its <b>preference neuron</b>, if it has
 *       one, says how much the module wants to decide; in each time step the module with the highest preference
 *       decides.
 *   <li><b>Division</b>: a rule written by a human that chooses the module by the situation in the game. A network
 *       whose modules are chosen so is <b>multitask</b> and has no preference neurons.
 *   <li><b>Method</b>: how modules arise and are chosen. {@code 1M}: one module. {@code 2M}, {@code 3M}: two or three
 *       modules with preference neurons. {@code MMD}: one module at first, and mutations that duplicate a module
 *       (module mutation by duplication). {@code MMR}: the same, but a new module has random links (none of the
 *       published experiments). {@code MT}: multitask; {@code MT2}, {@code MT3}: multitask with two or three modules,
 *       for the blended version, which has two divisions. {@code H21}: a hybrid of both ({@link
 *       mmneat.experiment.parameters.HybridMethod}).
 *   <li><b>Champion</b>: of a generation, the parent with the best champion score ({@link
 *       mmneat.evolution.Task#championScore}; in Ms.&nbsp;Pac-Man the mean game score). The champion of a run is that
 *       of the last generation that had children.
 *   <li><b>Front</b>: the Pareto front, the individuals of a population that no other individual dominates.
 *   <li><b>Archetype</b>: the population-wide list of neurons. It fixes the order of the neurons in every genotype.
 * </ul>
 */
@NullMarked
package mmneat.experiment;

import org.jspecify.annotations.NullMarked;
