package mmneat.analysis.results;

import com.fasterxml.jackson.core.type.TypeReference;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.dataformat.javaprop.JavaPropsMapper;
import com.fasterxml.jackson.dataformat.javaprop.JavaPropsSchema;
import java.io.IOException;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import mmneat.experiment.UserError;

/**
 * Reads the folder of a run, ours or the original's: the parents log for the champion's scores, the parameters, the evaluation.
 */
final class RunReader {

    private static final String PARENTS_LOG = "_parents_log.txt";

    /** Column 12 of the parents log, counted from 1: the best average game score (spec/evolution.md, section 5.2). */
    private static final int CHAMPION_SCORE_COLUMN = 12;

    private RunReader() {}

    /** Whether the folder is that of a run. */
    static boolean isRun(Path folder) {
        return file(folder, PARENTS_LOG).isPresent();
    }

    static RunResult read(Path folder) {
        Path log = file(folder, PARENTS_LOG).orElseThrow();
        Map<String, String> parameters = parameters(folder);
        return new RunResult(folder, number(folder, parameters), parameters, championScores(log), evaluation(folder));
    }

    private static double[] championScores(Path log) {
        List<Double> scores = new ArrayList<>();
        int line = 0;
        for (String row : lines(log)) {
            line++;
            String[] fields = row.split("\t");
            try {
                scores.add(Double.parseDouble(fields[CHAMPION_SCORE_COLUMN - 1]));
            } catch (NumberFormatException | ArrayIndexOutOfBoundsException e) {
                throw new UserError(
                        log + ", line " + line + ": no champion score in column " + CHAMPION_SCORE_COLUMN
                                + "; is this the log of a Ms. Pac-Man run?",
                        e);
            }
        }
        if (scores.isEmpty()) {
            throw new UserError(log + ": holds no generation yet; wait for the run or leave it out");
        }
        return scores.stream().mapToDouble(Double::doubleValue).toArray();
    }

    private static List<String> lines(Path file) {
        try {
            return Files.readAllLines(file, StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UserError(file + ": cannot be read: " + e.getMessage(), e);
        }
    }

    /** Ours, or the original's, whose lines {@code name:value} are properties as well. */
    private static Map<String, String> parameters(Path folder) {
        Path ours = folder.resolve("parameters.properties");
        Optional<Path> found = Files.exists(ours) ? Optional.of(ours) : file(folder, "_parameters.txt");
        if (found.isEmpty()) {
            return Map.of();
        }
        try (Reader reader = Files.newBufferedReader(found.get())) {
            return new JavaPropsMapper()
                    .readerFor(new TypeReference<Map<String, String>>() {})
                    .with(JavaPropsSchema.emptySchema().withoutPathSeparator())
                    .readValue(reader);
        } catch (IOException e) {
            throw new UserError(found.get() + ": cannot be read: " + e.getMessage(), e);
        }
    }

    private static int number(Path folder, Map<String, String> parameters) {
        String number = parameters.get("runNumber");
        if (number == null) {
            number = folder.getFileName().toString().replaceFirst("^.*?(\\d*)$", "$1");
        }
        return number.isEmpty() ? 0 : Integer.parseInt(number);
    }

    private static Optional<ChampionEvaluation> evaluation(Path folder) {
        Path file = folder.resolve(EvaluationFiles.summary("training"));
        if (!Files.exists(file)) {
            return Optional.empty();
        }
        try {
            return Optional.of(new ObjectMapper().readValue(file.toFile(), ChampionEvaluation.class));
        } catch (IOException e) {
            throw new UserError(file + ": cannot be read: " + e.getMessage() + "; run evaluate again", e);
        }
    }

    private static Optional<Path> file(Path folder, String ending) {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.getFileName().toString().endsWith(ending))
                    .sorted()
                    .findFirst();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
