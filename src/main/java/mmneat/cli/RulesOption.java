package mmneat.cli;

import java.util.ArrayList;
import mmneat.analysis.evaluation.Rules;
import picocli.CommandLine.Option;

/** The option {@code rules=}: the rules under which a champion plays. */
final class RulesOption {

    private static final class Labels extends ArrayList<String> {
        Labels() {
            super(Rules.labels());
        }
    }

    @Option(
            names = "rules",
            paramLabel = "RULES",
            completionCandidates = Labels.class,
            defaultValue = "training",
            description =
                    "Rules of the game: ${COMPLETION-CANDIDATES}. Under training rules Ms. Pac-Man has one life, as"
                            + " in evolution (default: ${DEFAULT-VALUE}).")
    private String label;

    Rules rules() {
        return Rules.of(label);
    }
}
