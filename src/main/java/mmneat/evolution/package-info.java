/**
 * Evolution of networks for a {@link mmneat.evolution.Task}: the (mu+lambda) loop with re-evaluated parents, champions
 * and the statistics of a generation.
 *
 * <p>The package depends on genotypes and selection but on no game. To evolve networks for another domain, implement
 * {@code Task}.
 *
 * <p>Source: Schrum and Miikkulainen 2016, section 5.2; docs/specification/evolution.md, sections 1 and 3.
 */
package mmneat.evolution;
