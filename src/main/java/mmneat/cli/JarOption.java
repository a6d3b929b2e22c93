package mmneat.cli;

import java.nio.file.Path;
import java.util.Optional;
import mmneat.analysis.evaluation.Champion;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The option {@code jar=}: the user's permission to load the classes that the folder of a run names. */
final class JarOption {

    @Option(
            names = "jar",
            paramLabel = "FILE",
            description =
                    "Jar with your own classes that the run was evolved with (docs/extend.md). Without it, no code that"
                            + " the folder of a run names is loaded.")
    private @Nullable Path jar;

    /** Returns the champion, with this jar for the classes of its run. */
    Champion allow(Champion champion) {
        return champion.withJar(file());
    }

    /** The jar; empty if none is given. */
    Optional<Path> file() {
        return Optional.ofNullable(jar);
    }
}
