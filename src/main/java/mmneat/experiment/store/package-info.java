/**
 * The folder of a run: its files, written so that they always belong to a complete generation, its checkpoints, its lock and its
 * status.
 */
package mmneat.experiment.store;
