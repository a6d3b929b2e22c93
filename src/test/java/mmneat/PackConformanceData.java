package mmneat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.IntPredicate;
import java.util.stream.Stream;
import java.util.zip.Deflater;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import mmneat.experiment.run.GoldenRun;
import mmneat.mspacman.GoldenEvaluations;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import pacman.game.CompactTraces;
import pacman.game.GhostPlaces;
import pacman.maze.MazeText;

/**
 * Makes {@code src/test/resources/conformance} from the full golden data: {@code scripts/pack-conformance}.
 *
 * <p>Not part of the build (the name does not end in Test). The README beside the packed files describes them.
 */
class PackConformanceData {

    private static final Path COMPACT = Path.of(System.getProperty("basedir", "."), "src/test/resources/conformance");

    private static final List<String> COMPLETE = List.of(
            "api",
            "controllers",
            "engine",
            "logs",
            "networks",
            "nsga2",
            "parameters",
            "runs-options",
            "sensors",
            "sensors-options",
            "statistics");

    /** Selects, for each pair of players, one game in each maze and from each power pill. */
    private static final IntPredicate GHOST_GAMES = game -> Set.of(3, 5, 6, 7).contains(game % 10);

    /** A constant time stamp, so that packing twice gives the same bytes. */
    private static final LocalDateTime STAMP = LocalDateTime.of(2016, 2, 1, 0, 0);

    @TempDir
    Path work;

    @BeforeEach
    void needFullData() throws IOException {
        assertThat(GoldenData.isFull()).as("golden.dir has the full data").isTrue();
        Files.createDirectories(COMPACT);
    }

    @Test
    void completeParts() throws IOException {
        for (String part : COMPLETE) {
            zip(part, GoldenData.folder(part));
        }
    }

    @Test
    void traces() throws IOException {
        Path traces = GoldenData.folder("traces");
        Path compact = Files.createDirectory(work.resolve("traces"));
        try (Stream<Path> files = Files.list(traces)) {
            for (Path file : files.toList()) {
                String name = file.getFileName().toString();
                Path target = compact.resolve(name);
                if (!name.endsWith(".jsonl.gz") || name.startsWith("queries")) {
                    Files.copy(file, target);
                } else {
                    CompactTraces.pack(file, target, name.startsWith("ghosttask") ? GHOST_GAMES : game -> true);
                }
            }
        }
        zip("traces", compact);
    }

    @Test
    void mazes() throws IOException {
        Path mazes = GoldenData.folder("mazes");
        Path compact = Files.createDirectory(work.resolve("mazes"));
        StringBuilder digests = new StringBuilder("# SHA-256 of each maze's text, as MazeText writes it.\n");
        for (String letter : List.of("a", "b", "c", "d")) {
            String text = MazeText.of(mazes.resolve(letter + ".json"));
            digests.append(letter).append('=').append(MazeText.digest(text)).append('\n');
        }
        Files.writeString(compact.resolve(MazeText.DIGESTS), digests);
        Files.copy(mazes.resolve("path-checksums.json"), compact.resolve("path-checksums.json"));
        zip("mazes", compact);
    }

    @Test
    void ghostLocations() throws IOException {
        String name = "PowerPillToGhostLocationMapping.txt";
        GhostPlaces places =
                new GhostPlaces(GoldenData.folder("ghost-locations").resolve(name));
        places.markGames(GoldenData.folder("traces").resolve("ghosttask.jsonl.gz"), GHOST_GAMES);
        for (int corner = 0; corner < 4; corner++) {
            places.markEngineRun(corner);
        }
        for (String evaluation : GoldenEvaluations.isolated()) {
            places.mark(locations -> GoldenEvaluations.isTheOriginals(evaluation, locations));
        }
        Path compact = Files.createDirectory(work.resolve("ghost-locations"));
        places.write(compact.resolve(name));
        assertThat(places.marked()).isLessThan(1600);
        zip("ghost-locations", compact);
    }

    /** The isolated runs would need all ghost locations of the original, so this program runs them with its own. */
    @Test
    void runs() throws Exception {
        Path golden = GoldenData.folder("runs");
        Path compact = Files.createDirectory(work.resolve("runs"));
        try (Stream<Path> files = Files.walk(golden)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Path target = compact.resolve(golden.relativize(file).toString());
                Files.createDirectories(target.getParent());
                Files.copy(file, target);
            }
        }
        try (Stream<Path> folders = Files.list(compact)) {
            for (Path folder : folders.filter(
                            path -> path.getFileName().toString().startsWith("Isolated"))
                    .toList()) {
                Path command = folder.resolve("command.txt");
                Files.writeString(
                        command, Files.readString(command).replaceAll(" ?mazePowerPillGhostMapping:\\S+", ""));
                Path base =
                        Files.createDirectory(work.resolve(folder.getFileName().toString()));
                GoldenRun recorded = new GoldenRun(folder);
                GoldenRun.run(recorded.commandLine(base));
                recorded.replaceFiles(base);
            }
        }
        zip("runs", compact);
    }

    private static void zip(String part, Path folder) throws IOException {
        TreeMap<String, Path> entries = new TreeMap<>();
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                String name = folder.relativize(file).toString().replace('\\', '/');
                if (!name.equals("README.md")) {
                    entries.put(name, file);
                }
            }
        }
        try (OutputStream out = Files.newOutputStream(COMPACT.resolve(part + ".zip"));
                ZipOutputStream zip = new ZipOutputStream(out)) {
            zip.setLevel(Deflater.BEST_COMPRESSION);
            for (String name : new ArrayList<>(entries.keySet())) {
                ZipEntry entry = new ZipEntry(name);
                entry.setTimeLocal(STAMP);
                zip.putNextEntry(entry);
                Files.copy(entries.get(name), zip);
                zip.closeEntry();
            }
        }
    }
}
