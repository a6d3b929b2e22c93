/**
 * Networks at work: a genotype compiled into flat arrays, its activation step by step, and the choice among its output
 * modules.
 *
 * <p>A {@link mmneat.neat.network.Network} is immutable and shared; what changes from step to step is in a state of its
 * own for every place where the network is used at the same time. Results are equal to the original's to the last bit.
 *
 * <p>Source: docs/specification/networks.md, sections 5 and 6.
 */
package mmneat.neat.network;
