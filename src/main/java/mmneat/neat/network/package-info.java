/**
 * Networks at work: a genotype compiled into flat arrays, its activation step by step, and the choice among its output
 * modules.
 *
 * <p>A {@link mmneat.neat.network.Network} is immutable and shared. A {@link mmneat.neat.network.NetworkState} holds
 * the activations of one running copy: a player that activates the network once per direction has four states. Results
 * are equal to those of the original (MM-NEAT, see {@link mmneat.neat}) to the last bit.
 *
 * <p>A step computes the neurons in the order of the genotype: inputs, hidden neurons, outputs. A link to a later
 * neuron is a forward link and acts in the same step. A link to the same or an earlier neuron is recurrent: it adds to
 * the neuron's sum of the next step, its pending sum. At the end of a step one module is chosen; the activations of its
 * policy neurons are the answer of the network.
 *
 * <p>Source: docs/specification/networks.md, sections 5 and 6.
 */
@NullMarked
package mmneat.neat.network;

import org.jspecify.annotations.NullMarked;
