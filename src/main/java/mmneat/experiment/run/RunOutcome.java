package mmneat.experiment.run;

import mmneat.experiment.store.RunStatus;

/**
 * The result of executing a run: how it ended and why.
 *
 * @param run the run
 * @param phase {@code FINISHED}, {@code ALREADY_FINISHED}, {@code IN_USE}, {@code REFUSED}, {@code FAILED} or {@code
 *     STOPPED}
 * @param status the last status, null if nothing was done or could be written
 * @param message one line for the user: why the run was not completed, or what was wrong with its folder; null if there
 *     was no problem
 * @param failure the exception; null if the run did not fail or if the message is sufficient
 */
public record RunOutcome(RunPlan run, RunMonitor.Phase phase, RunStatus status, String message, Throwable failure) {

    /** Whether the run is complete. */
    public boolean isComplete() {
        return phase == RunMonitor.Phase.FINISHED || phase == RunMonitor.Phase.ALREADY_FINISHED;
    }
}
