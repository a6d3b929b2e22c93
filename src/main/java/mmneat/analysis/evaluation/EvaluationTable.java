package mmneat.analysis.evaluation;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import mmneat.experiment.FileErrors;
import mmneat.experiment.PlainText;
import mmneat.experiment.TextFiles;
import mmneat.experiment.UserError;
import org.jspecify.annotations.Nullable;

/**
 * The games of an evaluation, read from its file. Every value is checked, because the file may be damaged or come from
 * another person. An incomplete last line, which an interrupted evaluation leaves, does not count.
 *
 * @param evaluation the evaluation to which all games belong
 * @param modules of the network that played
 * @param games at least one; game n is in place n and has the n-th seed of the evaluation
 */
record EvaluationTable(EvaluationName evaluation, int modules, List<GameResult> games) {

    private static final String REMEDY = "; delete the file to evaluate again";

    EvaluationTable {
        games = List.copyOf(games);
    }

    /**
     * Reads a file.
     *
     * @return empty if there is no file or no complete game in it
     * @throws UserError if the file cannot be read or holds an impossible value; the message names line and column
     */
    static Optional<EvaluationTable> read(Path file) {
        if (!Files.exists(file)) {
            return Optional.empty();
        }
        try {
            return parse(file, new String(TextFiles.bytes(file, TextFiles.TABLE_MIB), StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw FileErrors.unreadable(file, e);
        }
    }

    /** The same, of the content of a file. The file is not read, only named in messages. */
    static Optional<EvaluationTable> parse(Path file, String content) {
        // The part after the last line end is an incomplete line.
        List<String> lines =
                content.substring(0, content.lastIndexOf('\n') + 1).lines().toList();
        if (lines.isEmpty()) {
            if (!GameResult.canBeginHeader(content)) {
                throw damaged(file, 1, "it is not the header of a table of games");
            }
            return Optional.empty();
        }
        int modules = modules(file, lines.get(0));
        if (lines.size() == 1) {
            return Optional.empty();
        }
        String[] columns = lines.get(0).split(",");
        EvaluationName evaluation = name(file, lines.get(1));
        long[] seeds = evaluation.seeds(lines.size() - 1);
        List<GameResult> games = new ArrayList<>();
        for (String line : lines.subList(1, lines.size())) {
            try {
                games.add(game(line, columns, evaluation, games.size(), seeds));
            } catch (IllegalArgumentException e) {
                throw damaged(file, games.size() + 2, e.getMessage());
            }
        }
        return Optional.of(new EvaluationTable(evaluation, modules, games));
    }

    private static GameResult game(String line, String[] columns, EvaluationName evaluation, int number, long[] seeds) {
        GameResult game = GameResult.parse(line, columns);
        GameResult.require(game.number() == number, "game", game.number(), "be " + number + ", as games are in order");
        GameResult.require(
                game.seed() == seeds[number], "seed", game.seed(), "be " + seeds[number] + ", the seed of this game");
        String name = lastColumn(line);
        GameResult.require(
                name.equals(evaluation.text()), "evaluation", name, "be that of line 2, " + evaluation.text());
        return game;
    }

    /** The number of modules for which this is the header. */
    private static int modules(Path file, String header) {
        int modules = GameResult.modules(header.split(",", -1).length);
        if (modules < 1 || !header.equals(GameResult.header(modules))) {
            throw damaged(file, 1, "it is not the header of a table of games");
        }
        return modules;
    }

    private static EvaluationName name(Path file, String line) {
        try {
            return EvaluationName.of(lastColumn(line));
        } catch (IllegalArgumentException e) {
            throw damaged(file, 2, "column evaluation: '" + PlainText.shown(lastColumn(line)) + "': " + e.getMessage());
        }
    }

    private static String lastColumn(String line) {
        return line.substring(line.lastIndexOf(',') + 1);
    }

    private static UserError damaged(Path file, int line, @Nullable String problem) {
        return new UserError(file + ", line " + line + ": " + problem + REMEDY);
    }
}
