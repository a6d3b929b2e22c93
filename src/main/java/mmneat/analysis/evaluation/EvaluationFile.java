package mmneat.analysis.evaluation;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Optional;
import mmneat.experiment.FileErrors;
import mmneat.experiment.TextFiles;
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

    private Optional<Replaced> replaced = Optional.empty();

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
     * Returns the games that the file holds, if they are of this evaluation. Otherwise no game is returned, the file
     * becomes empty, and its table is kept as another file. An incomplete last line is dropped.
     *
     * @param name of this evaluation
     * @param modules of the network
     * @throws UserError if the table is damaged
     */
    List<GameResult> begin(EvaluationName name, int modules) {
        evaluation = name.text();
        try {
            if (channel.size() > (long) TextFiles.TABLE_MIB << 20) {
                throw new UserError(
                        file + ": is larger than " + TextFiles.TABLE_MIB + " MiB; delete the file to evaluate again");
            }
            String found = new String(Channels.newInputStream(channel).readAllBytes(), StandardCharsets.UTF_8);
            Optional<EvaluationTable> table = EvaluationTable.parse(file, found);
            boolean isSame = table.isPresent()
                    && table.get().modules() == modules
                    && table.get().evaluation().equals(name);
            List<GameResult> games = isSame ? table.get().games() : List.of();
            if (table.isPresent() && !isSame) {
                replaced = Optional.of(
                        new Replaced(table.get(), KeptFiles.keep(file, found.getBytes(StandardCharsets.UTF_8))));
            }
            String kept = GameResult.header(modules) + '\n' + lines(games);
            if (!found.startsWith(kept)) {
                channel.truncate(0);
                write(kept);
            }
            channel.truncate(kept.getBytes(StandardCharsets.UTF_8).length);
            return games;
        } catch (IOException e) {
            throw failure(e);
        }
    }

    /**
     * The table of another evaluation that {@link #begin} found.
     *
     * @param table its games
     * @param copy the file in which it is kept
     */
    record Replaced(EvaluationTable table, Path copy) {}

    /** The table of another evaluation that {@link #begin} found in the file; empty if there was none. */
    Optional<Replaced> replaced() {
        return replaced;
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
