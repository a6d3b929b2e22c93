package mmneat.analysis.results;

/** Names of the files that the evaluation of a champion leaves in the run's folder. */
public final class EvaluationFiles {

    private EvaluationFiles() {}

    /** The summary, a {@link ChampionEvaluation} as JSON. */
    public static String summary(String rules) {
        return "evaluation-" + rules + ".json";
    }

    /** Every game, one line each. */
    public static String games(String rules) {
        return "evaluation-" + rules + ".csv";
    }
}
