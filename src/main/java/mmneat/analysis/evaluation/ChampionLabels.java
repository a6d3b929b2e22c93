package mmneat.analysis.evaluation;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import mmneat.evolution.Task;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.PublishedTask;
import mmneat.experiment.parameters.Tasks;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TaskVersion;
import mmneat.mspacman.modules.ModuleDivision;
import mmneat.neat.ModuleLayout;
import mmneat.neat.io.NetworkLabels;

/**
 * Names of the inputs and modules of a champion, for pictures.
 *
 * @param labels the names
 * @param remark a remark for the reader; empty if the names are those of the champion's own task
 */
public record ChampionLabels(NetworkLabels labels, String remark) {

    /**
     * The names from the champion's task. If that task cannot be found or made, inputs and modules are numbered, and
     * the remark gives the reason.
     *
     * @param version of the task; if empty, the version of the champion's run, or if the run is unknown, a version with
     *     as many inputs as the champion's network has
     * @throws UserError if a version is given that the network does not suit
     */
    public static ChampionLabels of(Champion champion, Optional<TaskVersion> version) {
        try {
            Task task = ChampionTask.of(champion, version, Optional.of(Tasks.SHIPPED_LOCATIONS));
            boolean guessed = version.isEmpty()
                    && !ChampionTask.isToldByRun(champion, version)
                    && PublishedTask.version(champion.parameters()).isEmpty();
            return new ChampionLabels(
                    task instanceof MsPacManTask game
                            ? of(game.settings(), champion.genotype().layout())
                            : new NetworkLabels(task.inputLabels(), List.of()),
                    guessed
                            ? "inputs named as in task="
                                    + ChampionTask.version(champion).label()
                                    + ", which has the same number of inputs; task= chooses another version"
                            : "");
        } catch (UserError e) {
            if (version.isPresent()) {
                throw e;
            }
            return new ChampionLabels(NetworkLabels.NUMBERS, "inputs are numbered: " + e.getMessage());
        }
    }

    /**
     * Returns the names for a network that plays Ms.&nbsp;Pac-Man. Modules are numbered from 1. If a division chooses
     * modules, or groups of modules in a hybrid, the name of a module also says in which situation the division chooses
     * it or its group, for example "module 2: a ghost edible".
     */
    public static NetworkLabels of(MsPacManTaskSettings settings, ModuleLayout layout) {
        ModuleDivision division = layout.isDivided() ? settings.networks().division() : null;
        List<String> modules = IntStream.range(0, layout.modules())
                .mapToObj(module -> "module " + (module + 1)
                        + (division != null ? ": " + division.observation(layout.choiceOf(module)) : ""))
                .toList();
        return new NetworkLabels(SensorNames.of(new MsPacManTask(settings).inputLabels()), modules);
    }
}
