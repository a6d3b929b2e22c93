package mmneat.experiment.parameters;

import java.util.List;
import java.util.Locale;
import mmneat.experiment.NearestName;
import mmneat.experiment.UserError;

/** What is evolved. */
public enum TaskKind {
    /** Ghosts and pills at once: the game as it is. */
    BLENDED,
    /** Eaten ghosts stay in the lair while others can be eaten. */
    INTERLEAVED,
    /** Games with pills only and games with edible ghosts only. */
    ISOLATED,
    /** A class of the user's own. */
    OWN;

    private static final String GAME_CLASS = "MsPacManTask";
    private static final String ISOLATED_CLASS = "MsPacManPillsVsEdibleFromCornersMultitask";

    /**
     * The task that the parameters name, by a short name or by the class of the original.
     *
     * @throws UserError if they name none
     */
    public static TaskKind of(Parameters parameters) {
        String task = parameters.text("task");
        List<String> published = PublishedConfigurations.tasks();
        if (task.isEmpty()) {
            throw new UserError("task is missing; give it as task=" + String.join("|", published));
        }
        if (published.contains(task)) {
            TaskKind kind = valueOf(task.toUpperCase(Locale.ROOT));
            boolean imprisoned = parameters.flag("imprisonedWhileEdible");
            if (kind == BLENDED && imprisoned || kind == INTERLEAVED && !imprisoned) {
                throw new UserError("imprisonedWhileEdible=" + imprisoned + " does not go with task=" + task
                        + ": it is what makes the difference between blended and interleaved");
            }
            return kind;
        }
        if (task.equals(GAME_CLASS)) {
            return parameters.flag("imprisonedWhileEdible") ? INTERLEAVED : BLENDED;
        }
        if (task.equals(ISOLATED_CLASS)) {
            return ISOLATED;
        }
        if (task.contains(".") || parameters.isGiven("jar")) {
            return OWN;
        }
        throw new UserError("task=" + task + ": must be one of " + String.join(", ", published)
                + ", or the full name of a class of your own" + NearestName.suggestion(task, published));
    }

    /** As it is written in folder names. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
