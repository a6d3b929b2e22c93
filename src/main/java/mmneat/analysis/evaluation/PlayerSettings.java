package mmneat.analysis.evaluation;

import java.nio.file.Path;
import java.util.Optional;
import mmneat.experiment.UserError;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;

/** Finds out how a champion senses and plays: from the parameters of its run, or from the published ones of a version. */
public final class PlayerSettings {

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
        if (!(ChampionTask.of(champion, version, ghostLocations) instanceof MsPacManTask task)) {
            throw new UserError(champion.file() + ": was not evolved to play Ms. Pac-Man");
        }
        return withRules(task.settings(), rules);
    }

    /** Whether a champion was evolved to play Ms. Pac-Man. */
    public static boolean isPlayer(Champion champion) {
        return ChampionTask.of(champion, Optional.empty(), Optional.empty()) instanceof MsPacManTask;
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
}
