package mmneat.analysis.evaluation;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import mmneat.experiment.FileTrouble;
import mmneat.experiment.UserError;

/**
 * The CSV of an evaluation: a line per game, in order. Games are appended as they are finished, so an interrupted evaluation goes
 * on where it stopped.
 */
final class EvaluationFile {

    private final Path file;

    EvaluationFile(Path file) {
        this.file = file;
    }

    /**
     * The games that are there already, if they are of this evaluation; else the file is begun anew. A last line that was cut
     * off is dropped.
     *
     * @param seeds gives the seeds of the first games of the evaluation, as many as are asked for
     * @param title first line, names what is evaluated
     */
    List<GameResult> begin(String title, IntFunction<long[]> seeds) {
        List<GameResult> games = readable(title, seeds);
        StringBuilder text =
                new StringBuilder(title).append('\n').append(GameResult.HEADER).append('\n');
        games.forEach(game -> text.append(game.line()).append('\n'));
        try {
            Path unfinished = file.resolveSibling(file.getFileName() + ".new");
            Files.writeString(unfinished, text);
            Files.move(unfinished, file, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
        } catch (IOException e) {
            throw failure(e);
        }
        return games;
    }

    private List<GameResult> readable(String title, IntFunction<long[]> seeds) {
        List<GameResult> games = new ArrayList<>();
        if (!Files.exists(file)) {
            return games;
        }
        try {
            String text = Files.readString(file, StandardCharsets.UTF_8);
            // What stands behind the last line end was cut off.
            List<String> lines =
                    text.substring(0, text.lastIndexOf('\n') + 1).lines().toList();
            if (lines.size() < 2 || !lines.get(0).equals(title) || !lines.get(1).equals(GameResult.HEADER)) {
                return games;
            }
            long[] expected = seeds.apply(lines.size() - 2);
            for (String line : lines.subList(2, lines.size())) {
                GameResult game = GameResult.parse(line);
                if (game.seed() != expected[games.size()]) {
                    return new ArrayList<>();
                }
                games.add(game);
            }
            return games;
        } catch (IOException e) {
            throw failure(e);
        } catch (IllegalArgumentException e) {
            throw new UserError(file + ": " + e.getMessage() + "; delete the file to evaluate anew", e);
        }
    }

    void append(List<GameResult> games) {
        StringBuilder text = new StringBuilder();
        games.forEach(game -> text.append(game.line()).append('\n'));
        try {
            Files.writeString(file, text, StandardOpenOption.APPEND);
        } catch (IOException e) {
            throw failure(e);
        }
    }

    private UserError failure(IOException e) {
        return new UserError(file + ": cannot be written or read: " + FileTrouble.reason(e), e);
    }
}
