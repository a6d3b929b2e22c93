/**
 * Evolution of networks for a {@link mmneat.evolution.Task}: the (mu+lambda) loop with re-evaluated parents, champions and
 * the statistics of a generation.
 *
 * <p>The package knows genotypes and selection but no game: an implementation of {@code Task} for another domain gets the
 * same evolution.
 *
 * <p>Source: Schrum and Miikkulainen 2016, section 5.2; docs/specification/evolution.md, sections 1 and 3.
 */
package mmneat.evolution;
