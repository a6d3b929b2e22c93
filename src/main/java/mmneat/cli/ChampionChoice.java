package mmneat.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.ShippedChampions;
import mmneat.experiment.UserError;
import picocli.CommandLine.Option;

/** The option {@code champion=}: a shipped network, instead of a file or the folder of a run. */
final class ChampionChoice {

    private static final class Versions extends ArrayList<String> {
        Versions() {
            super(ShippedChampions.versions());
        }
    }

    @Option(
            names = "champion",
            paramLabel = "TASK",
            completionCandidates = Versions.class,
            description = "Uses, instead of FILE, the champion that comes with the program for this version of the task"
                    + " (${COMPLETION-CANDIDATES}).")
    private String version;

    boolean isGiven() {
        return version != null;
    }

    /**
     * Reads the network that the user chose.
     *
     * @param file the folder of a run or the file of a network; null if none is given
     * @param otherwise version of the champion to read if neither is given; if null, that is an error
     * @throws UserError if no network or more than one is chosen
     */
    Champion read(Path file, String otherwise) {
        if (file != null) {
            if (isGiven()) {
                throw new UserError("both a file and champion= are given; give one of them");
            }
            return Champion.read(file);
        }
        if (!isGiven() && otherwise == null) {
            throw new UserError("no network is given; name a run's folder or a file, or write champion="
                    + String.join("|", ShippedChampions.versions()));
        }
        return ShippedChampions.read(isGiven() ? version : otherwise);
    }
}
