package mmneat.cli.options;

import java.util.ArrayList;
import mmneat.analysis.evaluation.Rules;
import picocli.CommandLine.Option;

/**
 * The option {@code rules=} of the commands that evaluate or show champions: the rules of the champion's task, or these
 * rules with more lives ({@link Rules}). The commands {@code play} and {@code replay} have {@link GameOptions} instead.
 */
public final class RulesOption {

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

    public Rules rules() {
        return Rules.of(label);
    }
}
