/**
 * The folder of a run: its files, which always belong to a complete generation, its checkpoints, its lock and its
 * status. {@link mmneat.experiment.store.RunLayout} lists the files, and {@link mmneat.experiment} explains the terms:
 * the original, run, champion, archetype.
 *
 * <p>The state of a run has three forms. {@link mmneat.experiment.store.RunStatus.State} is what the run itself last
 * wrote to its folder. {@link mmneat.experiment.store.RunView.State} is what a reader of the folder concludes from that
 * and from the lock. {@link mmneat.experiment.run.RunMonitor.Phase} is what the executing program knows, without files.
 */
@NullMarked
package mmneat.experiment.store;

import org.jspecify.annotations.NullMarked;
