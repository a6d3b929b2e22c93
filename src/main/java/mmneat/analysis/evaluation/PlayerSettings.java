package mmneat.analysis.evaluation;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import mmneat.analysis.results.MethodName;
import mmneat.experiment.ParameterCatalogue;
import mmneat.experiment.ParameterReader;
import mmneat.experiment.Tasks;
import mmneat.experiment.UserError;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.neat.Genotype;

/** Finds out how a champion senses and plays: from the parameters of its run, or from the published ones of a version. */
public final class PlayerSettings {

    private static final int BLENDED_INPUTS = 30;

    private PlayerSettings() {}

    /**
     * The settings for a champion, one trial per evaluation.
     *
     * @param version blended, interleaved or isolated; if empty, that of the champion's run or what its inputs say
     * @param ghostLocations file of ghost locations for the isolated version, if not that of the run
     * @throws UserError if the network does not suit the version
     */
    public static MsPacManTaskSettings of(
            Champion champion, Optional<String> version, Rules rules, Optional<Path> ghostLocations) {
        List<String> words = new ArrayList<>();
        if (champion.parametersFile().isPresent() && version.isEmpty()) {
            words.add("config=" + champion.parametersFile().get());
        } else {
            String task = version.orElseGet(() -> version(champion));
            words.add("task=" + task);
            words.add("method=" + method(champion.genotype(), task));
        }
        ghostLocations.ifPresent(file -> words.add("mazePowerPillGhostMapping=" + file));
        var parameters =
                new ParameterReader(ParameterCatalogue.load()).read(words).parameters();
        if (!(Tasks.factory(parameters).get() instanceof MsPacManTask task)) {
            throw new UserError(champion.file() + ": was not evolved to play Ms. Pac-Man");
        }
        if (task.inputs() != champion.genotype().inputs()) {
            throw new UserError(champion.file() + ": the network has "
                    + champion.genotype().inputs() + " inputs, but this version of the task has " + task.inputs()
                    + " sensors; name the right one with task=blended, interleaved or isolated");
        }
        return withRules(task.settings(), rules);
    }

    private static MsPacManTaskSettings withRules(MsPacManTaskSettings settings, Rules rules) {
        return new MsPacManTaskSettings(
                settings.version(),
                1,
                rules.from(settings.rules()),
                settings.sensors(),
                settings.division(),
                settings.arbitration(),
                settings.ghosts(),
                settings.deterministic());
    }

    /** The version that a champion was evolved in. */
    private static String version(Champion champion) {
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
