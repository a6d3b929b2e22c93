package mmneat.cli.options;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.PlayerSettings;
import mmneat.analysis.evaluation.Rules;
import mmneat.experiment.UserError;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TaskVersion;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/**
 * The option {@code ghosts=} of the commands for champions (evaluate, report, tasks, watch): a file of recorded ghost
 * locations for the isolated version of the task. The option of the same name of {@code play} names a controller.
 */
public final class GhostsOption {

    private static final String NAME = "ghosts";

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(
            names = NAME,
            paramLabel = "FILE",
            description =
                    "Recorded ghost locations, for the isolated version of the task (default: those of the run, or those"
                            + " that come with the program).")
    private @Nullable Path file;

    /** Returns the settings with which a champion plays. */
    public MsPacManTaskSettings settings(Champion champion, TaskOption task, Rules rules) {
        // A version that does not use the file refuses the option, whether the file exists or not.
        MsPacManTaskSettings settings =
                PlayerSettings.of(champion, task.version(), rules, file().filter(Files::isReadable));
        requireEffect(
                settings.games().version() == TaskVersion.ISOLATED,
                "only the isolated version has recorded ghost locations, and " + champion.label() + " plays another");
        requireReadable();
        return settings;
    }

    /** As {@link #settings}; empty if the champion was evolved for another task than Ms. Pac-Man. */
    public Optional<MsPacManTaskSettings> findSettings(Champion champion, TaskOption task, Rules rules) {
        return PlayerSettings.find(champion, task.version(), rules, file());
    }

    /** Returns the file after checking that it is readable; empty if the option is not given. */
    public Optional<Path> readableFile() {
        requireReadable();
        return file();
    }

    /** Refuses the option where it has no effect. */
    public void requireEffect(boolean hasEffect, String reason) {
        OptionValues.requireEffect(command, NAME, hasEffect, reason);
    }

    private Optional<Path> file() {
        return Optional.ofNullable(file);
    }

    private void requireReadable() {
        if (file != null && !Files.isReadable(file)) {
            throw new UserError(NAME + "=" + file + ": the file is missing or not readable");
        }
    }
}
