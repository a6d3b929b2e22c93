package mmneat.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.PlayerSettings;
import mmneat.analysis.evaluation.Rules;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.PublishedConfigurations;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TaskVersion;

/** The words that say how a champion plays. */
final class ChampionWords {

    static final Word RULES = new Word(
            "rules", String.join("|", Rules.labels()), "the rules (default training: one life, as in evolution)");

    static final Word TASK = new Word(
            "task",
            String.join("|", PublishedConfigurations.tasks()),
            "version of the task (default: that of the run, or what the network's inputs say)");

    static final Word GHOSTS = new Word("ghosts", "FILE", "recorded ghost locations, for the isolated version");

    private ChampionWords() {}

    static Rules rules(Words words) {
        return Rules.of(words.text(RULES.name(), Rules.TRAINING.label()));
    }

    static MsPacManTaskSettings settings(Words words, Champion champion, Rules rules) {
        Optional<Path> ghosts = words.path(GHOSTS.name());
        // What the version does not use need not be there to be refused.
        MsPacManTaskSettings settings =
                PlayerSettings.of(champion, task(words), rules, ghosts.filter(Files::isReadable));
        words.requireEffect(
                GHOSTS.name(),
                settings.version() == TaskVersion.ISOLATED,
                "only the isolated version has recorded ghost locations, and " + champion.name() + " plays another");
        requireReadable(ghosts);
        return settings;
    }

    /** The same; empty if the champion was evolved for another task than Ms. Pac-Man. */
    static Optional<MsPacManTaskSettings> findSettings(Words words, Champion champion, Rules rules) {
        return PlayerSettings.find(champion, task(words), rules, words.path(GHOSTS.name()));
    }

    /** The file of ghost locations that is named, where there is one to be used. */
    static Optional<Path> ghosts(Words words) {
        Optional<Path> file = words.path(GHOSTS.name());
        requireReadable(file);
        return file;
    }

    private static void requireReadable(Optional<Path> ghosts) {
        if (ghosts.isPresent() && !Files.isReadable(ghosts.get())) {
            throw new UserError(GHOSTS.name() + "=" + ghosts.get() + ": there is no such file that can be read");
        }
    }

    private static Optional<String> task(Words words) {
        return words.has(TASK.name())
                ? Optional.of(words.choice(TASK.name(), "", PublishedConfigurations.tasks()))
                : Optional.empty();
    }
}
