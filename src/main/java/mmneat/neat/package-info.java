/**
 * Genotypes of modular neural networks: node and link genes, the arrangement of modules, innovation numbers and the
 * archetype.
 *
 * <p>A {@link mmneat.neat.Genotype} is immutable; a {@link mmneat.neat.GenotypeDraft} is its mutable form. A {@link
 * mmneat.neat.GenePool} holds what a population shares; its state can be read and set. Package {@link
 * mmneat.neat.variation} changes genotypes.
 *
 * <p>Source: Stanley and Miikkulainen 2002 (NEAT); Schrum and Miikkulainen 2016 (modules);
 * docs/specification/networks.md.
 */
package mmneat.neat;
