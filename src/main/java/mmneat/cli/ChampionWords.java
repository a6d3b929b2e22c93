package mmneat.cli;

import java.util.Optional;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.PlayerSettings;
import mmneat.analysis.evaluation.Rules;
import mmneat.experiment.PublishedConfigurations;
import mmneat.mspacman.MsPacManTaskSettings;

/** The words that say how a champion plays: {@code task=} and {@code ghosts=}. */
final class ChampionWords {

    private ChampionWords() {}

    static MsPacManTaskSettings settings(Words words, Champion champion, Rules rules) {
        Optional<String> task = words.has("task")
                ? Optional.of(words.choice("task", "", PublishedConfigurations.tasks()))
                : Optional.empty();
        return PlayerSettings.of(champion, task, rules, words.path("ghosts"));
    }
}
