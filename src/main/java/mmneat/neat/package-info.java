/**
 * Genotypes of modular neural networks and how they vary: node and link genes, innovation numbers, the archetype, initial
 * networks, mutation and crossover.
 *
 * <p>A {@link mmneat.neat.Genotype} is immutable. All randomness comes from the generator that is passed in, and all that a
 * population shares is in a {@link mmneat.neat.GenePool}, whose state can be read and set.
 *
 * <p>Source: Stanley and Miikkulainen 2002 (NEAT); Schrum and Miikkulainen 2016 (modules);
 * docs/specification/networks.md.
 */
package mmneat.neat;
