package mmneat.analysis.evaluation;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import mmneat.experiment.FileErrors;
import mmneat.experiment.UserError;

/**
 * The CSV table of an evaluation, with one line per game in order. Games are appended when they are finished, so an
 * interrupted evaluation can continue. While the table is open, other processes of this machine cannot open it.
 */
final class EvaluationFile implements AutoCloseable {

    /**
     * Position of the locked byte. It is far behind the data, so that other processes can read the file on any system.
     */
    private static final long LOCKED_BYTE = Long.MAX_VALUE - 1;

    private final Path file;
    private final FileChannel channel;

    /** The last column of every line; set by {@link #begin}. */
    private String evaluation = "";

    /**
     * Opens the file, and creates it if it does not exist.
     *
     * @throws UserError if it cannot be written, or is open already
     */
    EvaluationFile(Path file) {
        this.file = file;
        try {
            channel = FileChannel.open(
                    file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
        } catch (IOException e) {
            throw failure(e);
        }
        if (!lock()) {
            close();
            throw new UserError(file + ": another evaluation is writing this file; wait until it has finished");
        }
    }

    private boolean lock() {
        try {
            return channel.tryLock(LOCKED_BYTE, 1, false) != null;
        } catch (OverlappingFileLockException e) {
            return false;
        } catch (IOException e) {
            // A file system without locks: two evaluations at once cannot be prevented there.
            return true;
        }
    }

    /**
     * Reads the games that the file holds, if they are of this evaluation; otherwise the file is truncated. An
     * incomplete last line is dropped.
     *
     * @param seeds gives the seeds of the first games of the evaluation, as many as are asked for
     * @param name says which network plays by which rules; the last column of every line
     * @param modules of the network
     */
    List<GameResult> begin(String name, int modules, IntFunction<long[]> seeds) {
        evaluation = name;
        try {
            String found = new String(Channels.newInputStream(channel).readAllBytes(), StandardCharsets.UTF_8);
            String header = GameResult.header(modules);
            List<GameResult> games = readable(found, header, seeds);
            String kept = header + '\n' + lines(games);
            if (!found.startsWith(kept)) {
                channel.truncate(0);
                write(kept);
            }
            channel.truncate(kept.getBytes(StandardCharsets.UTF_8).length);
            return games;
        } catch (IOException e) {
            throw failure(e);
        } catch (IllegalArgumentException e) {
            throw new UserError(file + ": " + e.getMessage() + "; delete the file to evaluate again", e);
        }
    }

    private List<GameResult> readable(String text, String header, IntFunction<long[]> seeds) {
        List<GameResult> games = new ArrayList<>();
        // The part after the last line end is an incomplete line.
        List<String> lines =
                text.substring(0, text.lastIndexOf('\n') + 1).lines().toList();
        if (lines.isEmpty() || !lines.get(0).equals(header)) {
            return games;
        }
        long[] expected = seeds.apply(lines.size() - 1);
        for (String line : lines.subList(1, lines.size())) {
            if (!line.endsWith("," + evaluation)) {
                return new ArrayList<>();
            }
            GameResult game = GameResult.parse(line);
            if (game.seed() != expected[games.size()]) {
                return new ArrayList<>();
            }
            games.add(game);
        }
        return games;
    }

    void append(List<GameResult> games) {
        try {
            write(lines(games));
        } catch (IOException e) {
            throw failure(e);
        }
    }

    private String lines(List<GameResult> games) {
        StringBuilder text = new StringBuilder();
        games.forEach(game -> text.append(game.line(evaluation)).append('\n'));
        return text.toString();
    }

    private void write(String text) throws IOException {
        channel.position(channel.size());
        ByteBuffer bytes = StandardCharsets.UTF_8.encode(text);
        while (bytes.hasRemaining()) {
            channel.write(bytes);
        }
    }

    /** Closes the file and releases its lock. */
    @Override
    public void close() {
        try {
            channel.close();
        } catch (IOException e) {
            throw failure(e);
        }
    }

    private UserError failure(IOException e) {
        return new UserError(file + ": cannot be read or written: " + FileErrors.reason(e), e);
    }
}
