/**
 * Parameters: their catalogue, the layers that give them values (defaults, published settings, configuration file,
 * command line), and the settings of tasks and evolutions that are made from them. {@link mmneat.experiment} explains
 * the terms: the original, the paper, task, version, method, module, division.
 */
@NullMarked
package mmneat.experiment.parameters;

import org.jspecify.annotations.NullMarked;
