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
import mmneat.neat.ModuleLayout;
import mmneat.neat.io.NetworkLabels;

/**
 * What the inputs and modules of a champion are called in pictures.
 *
 * @param labels the names
 * @param remark what a reader should know about the names, empty if they are those of the champion's own task
 */
public record ChampionLabels(NetworkLabels labels, String remark) {

    /**
     * The names that the champion's task gives. A task that cannot be found or made is no reason not to draw a network: then
     * everything is numbered, and the remark says why.
     *
     * @param version of the task; if empty, that of the champion's run or what its inputs say
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
                                    + ", which has as many; task= names another"
                            : "");
        } catch (UserError e) {
            if (version.isPresent()) {
                throw e;
            }
            return new ChampionLabels(NetworkLabels.NUMBERS, "inputs are numbered: " + e.getMessage());
        }
    }

    /** The names for a network that plays Ms. Pac-Man; a module that a division chooses bears its observation. */
    public static NetworkLabels of(MsPacManTaskSettings settings, ModuleLayout layout) {
        boolean divided = layout.standardMultitask() && settings.division() != null;
        List<String> modules = IntStream.range(0, layout.modules())
                .mapToObj(module -> "module " + (module + 1)
                        + (divided ? ": " + settings.division().observation(module) : ""))
                .toList();
        return new NetworkLabels(SensorNames.of(new MsPacManTask(settings).inputLabels()), modules);
    }
}
