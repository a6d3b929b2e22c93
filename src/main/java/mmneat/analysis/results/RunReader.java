package mmneat.analysis.results;

import com.fasterxml.jackson.core.JacksonException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import mmneat.experiment.FileErrors;
import mmneat.experiment.JsonProblem;
import mmneat.experiment.PlainText;
import mmneat.experiment.TextFiles;
import mmneat.experiment.UserError;
import mmneat.experiment.store.OrdinaryFiles;
import mmneat.experiment.store.RunLayout;
import mmneat.neat.io.StrictJson;

/**
 * Reader of the folder of a run of this program or of the original: the champion's scores, the parameters, the
 * evaluation.
 *
 * <p>To read whole runs with parameters ({@link RunResult}) from outside of this package, use {@link
 * ExperimentFinder#find}; the folder of a single run is allowed there, too.
 */
public final class RunReader {

    /** The rules of the evaluations that experiments are compared by. */
    private static final String TRAINING = "training";

    private static final ObjectMapper JSON = StrictJson.mapper().build();

    private RunReader() {}

    /** Whether the folder is that of a run. */
    static boolean isRun(Path folder) {
        return Files.exists(folder.resolve(RunLayout.GENERATIONS))
                || RunLayout.parentsLogIn(folder).isPresent();
    }

    static RunResult read(Path folder) {
        OrdinaryFiles.requireIn(folder);
        Map<String, String> parameters = RunParameters.read(Optional.of(folder));
        return new RunResult(
                folder, number(folder, parameters), parameters, championScores(folder), evaluation(folder, TRAINING));
    }

    /**
     * Returns the score of each generation's champion. It is read from this program's table {@code generations.csv}, or
     * if that is missing, as in runs of the original, from the log of parents.
     *
     * @param folder the folder of the run
     * @throws UserError if the folder has neither file, or the file cannot be read
     */
    public static double[] championScores(Path folder) {
        Path table = folder.resolve(RunLayout.GENERATIONS);
        if (Files.exists(table)) {
            return column(table, 1, ",", RunLayout.championScoreColumnOfTable());
        }
        Path log = RunLayout.parentsLogIn(folder)
                .orElseThrow(() -> new UserError(
                        folder + ": " + RunLayout.GENERATIONS + " is missing; restore it or leave the run out"));
        return column(log, 0, "\t", ParentsLog.championScoreColumn(log));
    }

    private static double[] column(Path file, int headerLines, String separator, int column) {
        List<String> rows = TextFiles.lines(file);
        double[] scores = new double[Math.max(0, rows.size() - headerLines)];
        for (int i = 0; i < scores.length; i++) {
            String[] fields = rows.get(i + headerLines).split(separator);
            try {
                scores[i] = Double.parseDouble(fields[column - 1]);
                if (!Double.isFinite(scores[i])) {
                    throw new NumberFormatException(fields[column - 1]);
                }
            } catch (NumberFormatException | ArrayIndexOutOfBoundsException e) {
                throw new UserError(
                        file + ", line " + (i + headerLines + 1) + ": no champion score in column " + column
                                + "; is this a file of a finished run?",
                        e);
            }
        }
        if (scores.length == 0) {
            throw new UserError(file + ": holds no generation yet; wait for the run or leave it out");
        }
        return scores;
    }

    private static int number(Path folder, Map<String, String> parameters) {
        String number = parameters.get("runNumber");
        if (number == null) {
            number = folder.getFileName().toString().replaceFirst("^.*?(\\d*)$", "$1");
        }
        return number.isEmpty() ? 0 : Integer.parseInt(number);
    }

    /**
     * The evaluation of a run's champion.
     *
     * @param folder the folder of the run
     * @param rules label of the rules of the evaluation's games, e.g. {@code training}
     * @return empty if there is none, or if it is that of an earlier champion of the run
     * @throws UserError if the file is damaged or cannot be read
     */
    public static Optional<ChampionEvaluation> evaluation(Path folder, String rules) {
        Path file = folder.resolve(RunLayout.evaluationSummary(rules));
        if (!Files.exists(file)) {
            return Optional.empty();
        }
        ChampionEvaluation evaluation = json(file, ChampionEvaluation.class, "; remove it and run evaluate again");
        if (!evaluation.rules().equals(rules)) {
            throw new UserError(file + ": is damaged (rules cannot be " + PlainText.shown(evaluation.rules())
                    + "); remove it and run evaluate again");
        }
        // A continued run has another champion, to which this evaluation does not apply.
        return isOfChampion(evaluation, folder.resolve(RunLayout.CHAMPION))
                ? Optional.of(evaluation)
                : Optional.empty();
    }

    /** Whether an evaluation is of the champion in a file; true if there is no such file. */
    private static boolean isOfChampion(ChampionEvaluation evaluation, Path champion) {
        if (!Files.exists(champion)) {
            return true;
        }
        String remedy = "; restore it or leave the run out";
        JsonNode id = json(champion, JsonNode.class, remedy).path("id");
        if (!id.isIntegralNumber()) {
            throw new UserError(champion + ": is damaged (the network has no id)" + remedy);
        }
        return id.asLong() == evaluation.network();
    }

    private static <T> T json(Path file, Class<T> type, String remedy) {
        try {
            T value = JSON.readValue(TextFiles.bytes(file, TextFiles.TABLE_MIB), type);
            if (value == null) {
                throw new UserError(file + ": is damaged (its content is null)" + remedy);
            }
            return value;
        } catch (JacksonException e) {
            throw new UserError(file + ": is damaged (" + JsonProblem.of(e) + ")" + remedy, e);
        } catch (IOException e) {
            throw FileErrors.unreadable(file, e);
        }
    }
}
