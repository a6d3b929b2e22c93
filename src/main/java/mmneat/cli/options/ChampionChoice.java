package mmneat.cli.options;

import java.nio.file.Path;
import java.util.ArrayList;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.ShippedChampions;
import mmneat.experiment.UserError;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The option {@code champion=}: a shipped network, instead of a file or the folder of a run. */
public final class ChampionChoice {

    private static final class Names extends ArrayList<String> {
        Names() {
            super(ShippedChampions.names());
        }
    }

    @Option(
            names = "champion",
            paramLabel = "NAME",
            completionCandidates = Names.class,
            description =
                    "Uses, instead of FILE, a champion that comes with the program, named after the task's version"
                            + " (${COMPLETION-CANDIDATES}).")
    private @Nullable String name;

    public boolean isGiven() {
        return name != null;
    }

    /**
     * Reads the network that the user chose.
     *
     * @param file the folder of a run or the file of a network; null if none is given
     * @param otherwise name of the champion to read if neither is given; if null, that is an error
     * @throws UserError if no network or more than one is chosen
     */
    public Champion read(@Nullable Path file, @Nullable String otherwise) {
        if (file != null) {
            if (isGiven()) {
                throw new UserError("both a file and champion= are given; give one of them");
            }
            return Champion.read(file);
        }
        String chosen = name != null ? name : otherwise;
        if (chosen == null) {
            throw new UserError("no network is given; name a run's folder or a file, or write champion="
                    + String.join("|", ShippedChampions.names()));
        }
        return ShippedChampions.read(chosen);
    }
}
