package mmneat.experiment;

import java.util.function.Supplier;
import mmneat.evolution.Task;

/** Makes the tasks that parameters describe. */
final class Tasks {

    private Tasks() {}

    /**
     * Makes tasks, each for one thread.
     *
     * @throws UserError if the parameters describe none
     */
    static Supplier<Task> factory(ExperimentPlan plan) {
        Parameters parameters = plan.parameters();
        return switch (TaskKind.of(parameters)) {
            case OWN -> OwnTask.factory(parameters.text("task"), parameters.text("jar"), parameters.ofOwnTask());
            case BLENDED, INTERLEAVED, ISOLATED -> throw new UserError("not yet");
        };
    }
}
