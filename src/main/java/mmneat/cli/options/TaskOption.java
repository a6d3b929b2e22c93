package mmneat.cli.options;

import java.util.ArrayList;
import java.util.Optional;
import mmneat.mspacman.TaskVersion;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The option {@code task=}: the version of the task that a champion plays. */
public final class TaskOption {

    /** The versions of the task. */
    public static final class Versions extends ArrayList<String> {
        public Versions() {
            super(TaskVersion.labels());
        }
    }

    @Option(
            names = "task",
            paramLabel = "TASK",
            completionCandidates = Versions.class,
            description = "Version of the task: ${COMPLETION-CANDIDATES} (default: that of the run, or the one that the"
                    + " network's inputs fit).")
    private @Nullable String version;

    public Optional<TaskVersion> version() {
        return Optional.ofNullable(version).flatMap(TaskVersion::labelled);
    }
}
