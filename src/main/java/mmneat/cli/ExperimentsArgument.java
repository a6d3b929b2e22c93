package mmneat.cli;

import java.nio.file.Path;
import java.util.List;
import mmneat.analysis.results.Experiment;
import mmneat.analysis.results.ExperimentFinder;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Parameters;

/** The arguments that name the experiments of a command. */
final class ExperimentsArgument {

    @Parameters(
            arity = "0..*",
            paramLabel = "EXPERIMENT",
            description = "Folder of runs, or a prefix of such folders' names.")
    private @Nullable List<Path> paths;

    /**
     * Reads the experiments.
     *
     * @param command the command that was called
     * @throws mmneat.experiment.UserError if none is given, or a folder holds none
     */
    List<Experiment> find(ConsoleCommand command) {
        return ExperimentFinder.find(command.requireExperiments(paths));
    }
}
