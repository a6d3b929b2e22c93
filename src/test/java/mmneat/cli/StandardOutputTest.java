package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import mmneat.analysis.results.RunFixture;
import mmneat.cli.output.StandardOutput;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;
import picocli.CommandLine.Command;

/** Commands whose standard output cannot be written. */
class StandardOutputTest {

    @TempDir
    private static Path folder;

    private final StringWriter errors = new StringWriter();

    /** A full disk, or a pipe whose reader has ended. */
    private record Failing(String message) {
        OutputStream stream() {
            return new OutputStream() {
                @Override
                public void write(int b) throws IOException {
                    throw new IOException(message);
                }
            };
        }
    }

    private int execute(String message, List<String> words) {
        CommandLine line = Main.commandLine();
        line.setErr(new PrintWriter(errors, true));
        return Main.execute(line, new StandardOutput(new Failing(message).stream()), words.toArray(String[]::new));
    }

    static Stream<List<String>> commands() throws IOException {
        Path run = RunFixture.run(folder, "blended", "2M", 0, 1000);
        Stream<List<String>> helps = Main.commandLine().getSubcommands().keySet().stream()
                .flatMap(command -> Stream.of(List.of(command, "--help"), List.of(command, "--version")));
        Stream<List<String>> others = Stream.of(
                List.of(),
                List.of("--help"),
                List.of("--version"),
                List.of("help"),
                List.of("params"),
                List.of("params", "mu"),
                List.of("compare", run.getParent().toString()),
                List.of("network", "champion=blended", "out=-"),
                List.of("network", "champion=blended", "out=" + folder.resolve("network.svg")),
                List.of("play", "pacman=RandomPacMan"),
                List.of("watch", "champion=blended", "out=" + folder.resolve("game.html")),
                List.of("tasks", "task=blended", "games=1", "players=StarterPacMan"),
                List.of("report", run.getParent().toString(), "replays=none", "out=" + folder.resolve("report.html")));
        return Stream.concat(helps, others);
    }

    @ParameterizedTest
    @MethodSource("commands")
    void fullDisk_isAnError(List<String> words) {
        assertThat(execute("No space left on device", words)).isEqualTo(2);
        assertThat(errors.toString().lines().reduce((first, last) -> last))
                .contains("mmneat: standard output cannot be written: No space left on device");
    }

    @ParameterizedTest
    @MethodSource("commands")
    void closedPipe_isNoError(List<String> words) {
        assertThat(execute("Broken pipe", words)).isZero();
        assertThat(errors.toString()).doesNotContain("standard output");
    }

    @Command(name = "hungry")
    static final class Hungry implements Runnable {
        @Override
        public void run() {
            throw new OutOfMemoryError("Java heap space");
        }
    }

    @Test
    void exhaustedMemory_isOneLine() {
        CommandLine line = new CommandLine(new Hungry());
        line.setErr(new PrintWriter(errors, true));
        assertThat(Main.execute(line, new StandardOutput(OutputStream.nullOutputStream())))
                .isEqualTo(2);
        assertThat(errors.toString().lines())
                .containsExactly("mmneat: out of memory; check the files that the command names, or give Java"
                        + " more memory with the option -Xmx");
    }

    @Test
    void exitCodeOfAFailedCommand_stays() throws IOException {
        Path status = Files.createDirectories(folder.resolve("none"));
        assertThat(execute("No space left on device", List.of("status", status.toString())))
                .isEqualTo(2);
        assertThat(errors.toString()).isEqualTo("mmneat: " + status + ": holds no runs" + System.lineSeparator());
    }

    @Test
    void process_exitsWithAnError() throws IOException, InterruptedException {
        assumeThat(new File("/dev/full")).exists();
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        for (String word : List.of("--help", "--version", "params")) {
            Path messages = folder.resolve("messages.txt");
            Process process = new ProcessBuilder(
                            java, "-cp", System.getProperty("java.class.path"), Main.class.getName(), word)
                    .redirectOutput(new File("/dev/full"))
                    .redirectError(messages.toFile())
                    .start();
            assertThat(process.waitFor()).isEqualTo(2);
            assertThat(Files.readAllLines(messages))
                    .containsExactly("mmneat: standard output cannot be written: No space left on device");
        }
    }
}
