package mmneat.analysis.evaluation;

import java.nio.file.Path;
import java.util.Optional;
import mmneat.experiment.UserError;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TaskVersion;

/**
 * Determines the sensors and rules of a champion from the parameters of its run, or from the published parameters of a
 * version.
 */
public final class PlayerSettings {

    private PlayerSettings() {}

    /**
     * The settings for a champion, one trial per evaluation.
     *
     * @param version of the task; if empty, the version of the champion's run, or if the run is unknown, a version with
     *     as many inputs as the champion's network has
     * @param ghostLocations file of ghost locations for the isolated version, if not that of the run
     * @throws UserError if the network does not suit the version
     */
    public static MsPacManTaskSettings of(
            Champion champion, Optional<TaskVersion> version, Rules rules, Optional<Path> ghostLocations) {
        return find(champion, version, rules, ghostLocations)
                .orElseThrow(() -> new UserError(champion.file() + ": was not evolved to play Ms. Pac-Man"));
    }

    /** The same; empty if the champion was evolved for another task than Ms. Pac-Man. */
    public static Optional<MsPacManTaskSettings> find(
            Champion champion, Optional<TaskVersion> version, Rules rules, Optional<Path> ghostLocations) {
        if (ChampionTask.isOfOwnTask(champion, version)) {
            return Optional.empty();
        }
        champion.requireActivation();
        return ChampionTask.of(champion, version, ghostLocations) instanceof MsPacManTask task
                ? Optional.of(task.settings()
                        .withGames(games -> games.withRules(rules::from).withTrials(1)))
                : Optional.empty();
    }
}
