/**
 * Evolution of networks for a {@link mmneat.evolution.Task}: the (mu+lambda) loop with re-evaluated parents, champions
 * and the statistics of a generation.
 *
 * <p>The package depends on genotypes and selection but on no game. To evolve networks for another domain, implement
 * {@code Task}, or call {@link mmneat.evolution.Task#of} with an evaluation function; {@link
 * mmneat.evolution.Evolution#of} starts an evolution.
 *
 * <p>A <em>run</em> is one evolution with one seed. An <em>evaluation</em> of an individual consists of one or more
 * <em>trials</em>, whose scores are combined. A trial consists of one or more <em>episodes</em>: an episode is a
 * simulation from a start to an end, such as one game. {@code mmneat.neat} explains the words original, published
 * experiments, quirk, module, policy neuron, preference neuron, and the methods (1M, 2M, MM(D), MT and others). A name
 * in brackets, such as ({@code mu}), is the parameter of the command line that sets a value.
 *
 * <p>Source: Schrum and Miikkulainen 2016, section 5.2; docs/specification/evolution.md, sections 1 and 3.
 */
@NullMarked
package mmneat.evolution;

import org.jspecify.annotations.NullMarked;
