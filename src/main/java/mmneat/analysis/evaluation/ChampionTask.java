package mmneat.analysis.evaluation;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import mmneat.analysis.results.MethodName;
import mmneat.evolution.Task;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.parameters.Tasks;
import mmneat.neat.Genotype;

/** Finds the task of a champion: that of its run, or the published one that its network suits. */
final class ChampionTask {

    private static final int BLENDED_INPUTS = 30;

    private ChampionTask() {}

    /**
     * The task of a champion.
     *
     * @param version blended, interleaved or isolated; if empty, that of the champion's run or what its inputs say
     * @param ghostLocations file of ghost locations for the isolated version, if not that of the run
     * @throws UserError if the network does not suit the task, or the task cannot be made
     */
    static Task of(Champion champion, Optional<String> version, Optional<Path> ghostLocations) {
        List<String> words = new ArrayList<>();
        if (isToldByRun(champion, version)) {
            words.add("config=" + champion.parametersFile().get());
        } else {
            String task = version.orElseGet(() -> version(champion));
            words.add("task=" + task);
            words.add("method=" + method(champion.genotype(), task));
        }
        ghostLocations.ifPresent(file -> words.add("mazePowerPillGhostMapping=" + file));
        Task task = Tasks.factory(new ParameterReader(ParameterCatalogue.load())
                        .read(words)
                        .parameters())
                .get();
        if (task.inputs() != champion.genotype().inputs()) {
            throw new UserError(champion.file() + ": the network has "
                    + champion.genotype().inputs() + " inputs, but this version of the task has " + task.inputs()
                    + " sensors; name the right one with task=blended, interleaved or isolated");
        }
        return task;
    }

    /** Whether the parameters of its run say what the champion's task is. */
    static boolean isToldByRun(Champion champion, Optional<String> version) {
        return version.isEmpty() && champion.parametersFile().isPresent();
    }

    /** The version that a champion was evolved in, or the one that has as many sensors. */
    static String version(Champion champion) {
        String version = MethodName.version(champion.parameters());
        if (!version.isEmpty()) {
            return version;
        }
        return champion.genotype().inputs() == BLENDED_INPUTS ? "blended" : "interleaved";
    }

    /** Of the method only the division of a multitask network matters here. */
    private static String method(Genotype genotype, String version) {
        if (!genotype.layout().standardMultitask()) {
            return "1M";
        }
        return version.equals("blended") ? "MT" + genotype.modules() : "MT";
    }
}
