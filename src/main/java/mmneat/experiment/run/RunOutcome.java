package mmneat.experiment.run;

import mmneat.experiment.store.RunStatus;
import org.jspecify.annotations.Nullable;

/**
 * The result of executing a run: how it ended and why.
 *
 * @param run the run
 * @param phase how it ended: {@code FINISHED}, {@code ALREADY_FINISHED}, {@code IN_USE}, {@code REFUSED} (an error of
 *     the user, found before the start), {@code FAILED} (an exception after the start) or {@code STOPPED}
 * @param status the last status that was written to its folder; null in the phases {@code IN_USE}, {@code REFUSED} and
 *     {@code STOPPED}, or if a failure could not be written
 * @param message one line for the user: why the run was not completed, or what was wrong with its folder; null if there
 *     was no problem
 * @param failure the exception; null if the run did not fail or if the message is sufficient
 */
public record RunOutcome(
        RunPlan run,
        RunMonitor.Phase phase,
        @Nullable RunStatus status,
        @Nullable String message,
        @Nullable Throwable failure) {

    /** Whether the run is complete. */
    public boolean isComplete() {
        return phase == RunMonitor.Phase.FINISHED || phase == RunMonitor.Phase.ALREADY_FINISHED;
    }
}
