/**
 * Variation of genotypes: initial networks, mutation operators, crossover and reproduction.
 *
 * <p>All randomness comes from the generator that is passed in. The order of the draws is part of the behaviour: it
 * follows the original.
 *
 * <p>Source: Stanley and Miikkulainen 2002 (NEAT); Schrum and Miikkulainen 2016 (modules);
 * docs/specification/networks.md.
 */
@NullMarked
package mmneat.neat.variation;

import org.jspecify.annotations.NullMarked;
