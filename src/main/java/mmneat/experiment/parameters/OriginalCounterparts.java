package mmneat.experiment.parameters;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Texts for error messages: what to use instead of a feature of the original that this program refuses. The features
 * are parameters, experiment classes, and program modes (the first argument of the original, such as {@code process}).
 *
 * <p>Source: docs/specification/evolution.md, sections 4.1 and 6.1.
 */
final class OriginalCounterparts {

    private static final String WATCH = "use the command 'watch FOLDER' (window=true for a window)";
    private static final String EVALUATE = "use the command 'evaluate FOLDER'";
    private static final String REPORT = "use the command 'evaluate FOLDER report=true'";
    private static final String RECORD = "use the command 'play pacman=FOLDER record=FILE'";
    private static final String REPLAY = "use the command 'replay FILE'";

    private static final Map<String, String> BY_PARAMETER = byParameter();

    private OriginalCounterparts() {}

    private static Map<String, String> byParameter() {
        Map<String, String> counterparts = new HashMap<>();
        List.of(
                        "watch",
                        "showNetworks",
                        "monitorInputs",
                        "animateNetwork",
                        "modePheremone",
                        "scentMode",
                        "stepByStepPacMan")
                .forEach(name -> counterparts.put(name, WATCH));
        List.of("printFitness", "logPacManEvals", "logDeathLocations")
                .forEach(name -> counterparts.put(name, EVALUATE));
        counterparts.put("evalReport", REPORT);
        List.of("recordPacman", "pacmanSaveFile").forEach(name -> counterparts.put(name, RECORD));
        counterparts.put("replayPacman", REPLAY);
        counterparts.put("pacmanReplayDelay", "use the command 'replay FILE delay=MILLISECONDS'");
        counterparts.put("logGhostLocOnPowerPill", "use the command 'record-ghosts FOLDER'");
        counterparts.put("timedPacman", "use the command 'play pacman=FOLDER timed=true'");
        return counterparts;
    }

    /** Returns what to use instead of a parameter with a refused value; empty if there is nothing. */
    static Optional<String> ofParameter(String name, String value) {
        return name.equals("experiment") ? ofExperiment(value) : Optional.ofNullable(BY_PARAMETER.get(name));
    }

    private static Optional<String> ofExperiment(String className) {
        if (className.endsWith("ObjectiveBestNetworksExperiment")) {
            return Optional.of(
                    "use the command 'evaluate FILE' or 'watch FILE' with a file of the folder bestObjectives");
        }
        if (className.endsWith("BestNetworkExperiment")) {
            return Optional.of("use the command 'evaluate FOLDER' or 'watch FOLDER'");
        }
        if (className.endsWith("LoadAndWatchExperiment")) {
            return Optional.of("use the command 'watch FILE' with the file of a network");
        }
        return Optional.empty();
    }

    /** Returns what to use instead of a mode, the first argument of the original; empty if the name is not a mode. */
    static Optional<String> ofMode(String mode, String value) {
        return Optional.ofNullable(
                switch (mode) {
                    case "multiple" -> "write runs=" + value;
                    case "process" -> "use the command 'process' with the parameters of the runs and runs=" + value;
                    case "hv" ->
                        "use the command 'process' with the parameters of the runs and runs=" + value
                                + "; it writes the hypervolumes too";
                    case "lineage" ->
                        "there is no lineage browser; the file ..._Lineage_log.txt of a run lists the parents of each child";
                    default -> null;
                });
    }
}
