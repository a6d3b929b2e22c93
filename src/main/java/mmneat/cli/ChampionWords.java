package mmneat.cli;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.PlayerSettings;
import mmneat.analysis.evaluation.Rules;
import mmneat.experiment.PublishedConfigurations;
import mmneat.experiment.UserError;
import mmneat.mspacman.MsPacManTaskSettings;
import pacman.game.GhostLocations;

/** The words that say how a champion plays: {@code task=} and {@code ghosts=}. */
final class ChampionWords {

    private ChampionWords() {}

    static MsPacManTaskSettings settings(Words words, Champion champion, Rules rules) {
        Optional<String> task = words.has("task")
                ? Optional.of(words.choice("task", "", PublishedConfigurations.tasks()))
                : Optional.empty();
        return PlayerSettings.of(champion, task, rules, words.path("ghosts").map(ChampionWords::locations));
    }

    private static GhostLocations locations(Path file) {
        try (Reader text = Files.newBufferedReader(file)) {
            return GhostLocations.read(file.toString(), text);
        } catch (IOException | IllegalArgumentException e) {
            throw new UserError("ghosts=" + file + ": " + e.getMessage(), e);
        }
    }
}
