/**
 * Genotypes of modular neural networks: node and link genes, the arrangement of modules, innovation numbers and the
 * archetype.
 *
 * <p>A {@link mmneat.neat.Genotype} is immutable; a {@link mmneat.neat.GenotypeDraft} is its mutable form. A {@link
 * mmneat.neat.GenePool} holds what a population shares; its state can be read and set. Package {@link
 * mmneat.neat.variation} changes genotypes.
 *
 * <p>Words used in the packages of networks and evolution:
 *
 * <ul>
 *   <li><em>The original</em> is MM-NEAT, the program of J. Schrum and R. Miikkulainen, version of February 2016. The
 *       <em>published experiments</em> are those of <em>the paper</em>, which it made: J. Schrum and R. Miikkulainen,
 *       Solving Multiple Isolated, Interleaved, and Blended Tasks through Modular Neuroevolution, Evolutionary
 *       Computation 24(3), 2016. A <em>quirk</em> is a behaviour of the original that looks like a fault; it is kept,
 *       because results must be equal.
 *   <li>An output <em>module</em> is a group of output neurons that can answer for the network. Its <em>policy
 *       neurons</em> are the answer. Its <em>preference neuron</em>, if it has one, says how much the module should be
 *       chosen: in each step the module with the highest activation of its preference neuron answers.
 *   <li><em>Methods</em> of the paper: 1M has one module. 2M and 3M have two and three modules with preference neurons.
 *       MMD, or MM(D), starts with one module and adds copies of modules by mutation; MM(P) and MM(R) add other new
 *       modules. MT, MT2 and MT3 are multitask networks: they have two, two and three modules without preference
 *       neurons, and the task says which module answers ({@code ModuleDivision} of the Ms.&nbsp;Pac-Man task).
 *   <li>A <em>hybrid</em> is a method of this program: the modules form groups, the task says which group answers, and
 *       preference neurons choose a module within the group ({@link mmneat.neat.ModuleLayout#grouped}).
 *   <li><em>Full module mutation</em> adds a module that is linked to all inputs. <em>Excess crossover</em> gives both
 *       children all genes of both parents. The published experiments use neither.
 *   <li>A name in brackets after a description, such as ({@code netLinkRate}), is the parameter of the command line
 *       that sets the value (docs/parameters.md). Parameters say "mode" where the paper says "module".
 * </ul>
 *
 * <p>Source: Stanley and Miikkulainen 2002 (NEAT); Schrum and Miikkulainen 2016 (modules);
 * docs/specification/networks.md.
 */
@NullMarked
package mmneat.neat;

import org.jspecify.annotations.NullMarked;
