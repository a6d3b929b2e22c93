package pacman.game;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStreamWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.zip.CRC32;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;

/**
 * The compact form of a trace file: a step keeps only its inputs, and a checksum stands for its values.
 *
 * <p>A step is Ms. Pac-Man's input and the ghosts' input without quotes ({@code U....} or {@code Unull}). A line {@code
 * #xxxxxxxx} is the CRC-32 of all full step lines of the game so far. There is one after every {@value #STEPS} steps
 * and before every line of another type, so that every step is checked. Lines of other types are kept.
 */
public final class CompactTraces {

    /** Steps between two checksums. */
    static final int STEPS = 50;

    private CompactTraces() {}

    /**
     * Writes the compact form of a full trace file.
     *
     * @param keeps whether to keep a game, by its number in the file from 0
     */
    public static void pack(Path full, Path compact, IntPredicate keeps) throws IOException {
        try (BufferedWriter out = new BufferedWriter(
                new OutputStreamWriter(new GZIPOutputStream(Files.newOutputStream(compact)), StandardCharsets.UTF_8))) {
            Checksum checksum = new Checksum();
            int game = -1;
            for (String line : lines(full)) {
                if (line.startsWith("{\"type\":\"game\"")) {
                    game++;
                }
                if (game >= 0 && !line.startsWith("{\"type\":\"rules\"") && !keeps.test(game)) {
                    continue;
                }
                if (line.startsWith("[")) {
                    out.write(line.charAt(2) + line.substring(6, line.indexOf('"', 6)) + "\n");
                    checksum.add(line);
                    if (checksum.unwritten == STEPS) {
                        out.write(checksum.take() + "\n");
                    }
                } else {
                    if (checksum.unwritten > 0) {
                        out.write(checksum.take() + "\n");
                    }
                    if (line.startsWith("{\"type\":\"game\"")) {
                        checksum = new Checksum();
                    }
                    out.write(line + "\n");
                }
            }
        }
    }

    /** Returns the games of a full trace file, each preceded by the line of its rules. */
    static List<List<String>> games(Path full, IntPredicate keeps) throws IOException {
        List<List<String>> games = new ArrayList<>();
        String rules = null;
        int number = -1;
        for (String line : lines(full)) {
            if (line.startsWith("{\"type\":\"rules\"")) {
                rules = line;
            } else {
                if (line.startsWith("{\"type\":\"game\"")) {
                    number++;
                    if (keeps.test(number)) {
                        games.add(new ArrayList<>(List.of(rules)));
                    }
                }
                if (keeps.test(number)) {
                    games.get(games.size() - 1).add(line);
                }
            }
        }
        return games;
    }

    private static List<String> lines(Path gzip) throws IOException {
        try (BufferedReader in = new BufferedReader(new InputStreamReader(
                new GZIPInputStream(Files.newInputStream(gzip), 1 << 16), StandardCharsets.UTF_8))) {
            return in.lines().toList();
        }
    }

    /** The running checksum of a game's full step lines. */
    static final class Checksum {

        private final CRC32 crc = new CRC32();
        private int unwritten;

        void add(String line) {
            crc.update(line.getBytes(StandardCharsets.UTF_8));
            unwritten++;
        }

        /** Returns the line with the checksum so far. */
        String take() {
            unwritten = 0;
            return String.format("#%08x", crc.getValue());
        }
    }
}
