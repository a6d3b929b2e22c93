/**
 * The folder of a run: its files, which always belong to a complete generation, its checkpoints, its lock and its
 * status.
 */
package mmneat.experiment.store;
