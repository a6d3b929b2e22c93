package mmneat.analysis.evaluation;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import mmneat.evolution.Task;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.parameters.PublishedTask;
import mmneat.experiment.parameters.Tasks;
import mmneat.mspacman.TaskVersion;
import mmneat.mspacman.sensors.SensorSettings;
import mmneat.mspacman.sensors.suite.SensorSuite;
import mmneat.neat.Genotype;

/** Determines the task of a champion: the task of its run, or the published task that fits its network. */
final class ChampionTask {

    private static final int BLENDED_INPUTS = 30;

    private ChampionTask() {}

    /**
     * The task of a champion.
     *
     * @param version of the task; if empty, the version of the champion's run, or if the run is unknown, a version with
     *     as many inputs as the champion's network has
     * @param ghostLocations file of ghost locations for the isolated version, if not that of the run
     * @throws UserError if the network does not fit the task, or the task cannot be made
     */
    static Task of(Champion champion, Optional<TaskVersion> version, Optional<Path> ghostLocations) {
        List<String> words = new ArrayList<>();
        if (isToldByRun(champion, version)) {
            if (ghostLocations.isEmpty()) {
                requireRecording(champion);
            }
            words.add("config=" + champion.parametersFile().get());
            champion.jar().ifPresent(jar -> words.add("jar=" + jar));
        } else {
            TaskVersion task = version.orElseGet(() -> version(champion));
            words.add("task=" + task.label());
            words.add("method=" + method(champion.genotype(), task));
            if (hasSplitSensors(champion)) {
                words.addAll(List.of("specificGhostEdibleThreatSplit=true", "specificGhostProximityOrder=false"));
            }
        }
        ghostLocations.ifPresent(file -> words.add(Tasks.GHOST_LOCATIONS + "=" + file));
        Task task = Tasks.factory(new ParameterReader(ParameterCatalogue.load())
                        .readForGames(words)
                        .parameters())
                .get();
        if (task.inputs() != champion.genotype().inputs()) {
            throw new UserError(champion.file() + ": the network has "
                    + champion.genotype().inputs() + " inputs, but this version of the task has " + task.inputs()
                    + " sensors; name the right one with task=blended, interleaved or isolated");
        }
        return task;
    }

    /**
     * Checks that the recording of ghost locations that the run used is in its folder, as our runs keep it. A file
     * elsewhere is not read, because the folder may come from another person. That of an original's run is never there.
     */
    private static void requireRecording(Champion champion) {
        String file = champion.parameters().getOrDefault(Tasks.GHOST_LOCATIONS, "");
        boolean isIsolated = PublishedTask.version(champion.parameters()).equals(Optional.of(TaskVersion.ISOLATED));
        if (isIsolated
                && !file.isEmpty()
                && !isInFolder(file, champion.parametersFile().get())) {
            throw new UserError(champion.file() + ": the file with the ghost locations of its run is not in the run's"
                    + " folder: " + PlainText.shown(file) + "; give it with ghosts=FILE");
        }
    }

    private static boolean isInFolder(String name, Path parametersFile) {
        try {
            Path file = parametersFile.resolveSibling(name);
            return Path.of(name).equals(file.getFileName()) && Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS);
        } catch (InvalidPathException e) {
            return false;
        }
    }

    /** Whether the parameters of its run determine the champion's task. */
    static boolean isToldByRun(Champion champion, Optional<TaskVersion> version) {
        return version.isEmpty() && champion.parametersFile().isPresent();
    }

    /** Whether the run's parameters name a task class of the user; the class is not loaded. */
    static boolean isOfOwnTask(Champion champion, Optional<TaskVersion> version) {
        return isToldByRun(champion, version)
                && !champion.parameters().getOrDefault("task", "").isEmpty()
                && PublishedTask.version(champion.parameters()).isEmpty();
    }

    /** The version that a champion was evolved in, or the one that has as many sensors. */
    static TaskVersion version(Champion champion) {
        return PublishedTask.version(champion.parameters())
                .orElse(
                        champion.genotype().inputs() == BLENDED_INPUTS || hasSplitSensors(champion)
                                ? TaskVersion.BLENDED
                                : TaskVersion.INTERLEAVED);
    }

    /** Whether a network has as many inputs as those of the experiments with split sensors, of any version. */
    private static boolean hasSplitSensors(Champion champion) {
        return champion.genotype().inputs()
                == SensorSuite.of(SensorSettings.split()).size();
    }

    /** Of the method only the division of a multitask network matters here. */
    private static String method(Genotype genotype, TaskVersion version) {
        return genotype.layout().isDivided()
                ? PublishedTask.multitask(
                        Optional.of(version), genotype.layout().choicesOfTask())
                : "1M";
    }
}
